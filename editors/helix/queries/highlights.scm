; Colours in the names of Helix; otherwise as tree-sitter-ifs/queries/highlights.scm.

(name) @variable

; Reserved words: TokenKind::keywords() of the compiler, each once.
[
  "use"
  "param"
  "let"
  "fn"
  "record"
  "ifs"
  "figure"
  "fabricate"
  "test"
  "for"
  "in"
  "on"
  "at"
] @keyword

[
  "if"
  "then"
  "else"
] @keyword.control.conditional

(visibility) @keyword.storage.modifier ; "pub"

(self) @variable.builtin ; "self"

(boolean) @constant.builtin.boolean ; "true" "false"

; Words that mean something in their place only.
[
  "as"
  "assert"
  "boundary"
  "each"
  "germ"
  "join"
  "keep"
  "level"
  "plane"
  "require"
  "space"
  "step"
  "transform"
  "until"
] @keyword

[
  "and"
  "by"
  "not"
  "or"
] @keyword.operator

; Declarations.
(param_item name: (name) @variable.parameter)
(parameter name: (label) @variable.parameter)
(function_item name: (name) @function)
(ifs_item name: (name) @function)
(figure_item name: (name) @constant)
(fabricate_item figure: (name) @constant)
(fabricate_item kind: (name) @type)
(transform_member name: (name) @label)
(boundary_member name: (name) @label)
(boundary_path (name) @label)
(control_point name: (name) @variable.parameter)
(for_clause name: (name) @variable)
(family name: (name) @variable)
(record_item name: (name) @type)
(type_name (name) @type)
(module_path (name) @namespace)

; Uses.
(call function: (name) @function)
(call
  function: (name) @constructor
  (#match? @constructor "^[A-Z]"))
(on_expression ifs: (name) @function)
(field_access field: (name) @variable.other.member)
(field name: (label) @variable.other.member)
(setting name: (label) @variable.other.member)
(argument name: (label) @variable.parameter)
(measure (name) @variable.other.member)

; Values.
(number) @constant.numeric
(unit) @type.builtin
(text) @string
(escape_sequence) @constant.character.escape

; Signs.
[
  "+"
  "-"
  "*"
  "/"
  "="
  "->"
  ".."
  (comparison_operator)
] @operator

[
  "("
  ")"
  "["
  "]"
  "{"
  "}"
] @punctuation.bracket

[
  ","
  ":"
  "."
] @punctuation.delimiter

(comment) @comment
[
  (doc_comment)
  (file_doc_comment)
] @comment.block.documentation
