; What the outline shows: every named item, and the members of an ifs.
(param_item "param" @context name: (name) @name) @item
(let_item "let" @context name: (name) @name) @item
(function_item "fn" @context name: (name) @name) @item
(record_item "record" @context name: (name) @name) @item
(ifs_item "ifs" @context name: (name) @name) @item
(transform_member "transform" @context name: (name) @name) @item
(boundary_member "boundary" @context name: (name) @name) @item
(figure_item "figure" @context name: (name) @name) @item
(fabricate_item "fabricate" @context figure: (name) @name) @item
(test_item "test" @context name: (text) @name) @item
