; Colours. Later patterns win where several match.

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
] @keyword.conditional

(visibility) @keyword.modifier ; "pub"

(self) @variable.builtin ; "self"

(boolean) @boolean ; "true" "false"

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
(module_path (name) @module)

; Uses.
(call function: (name) @function.call)
(call
  function: (name) @constructor
  (#match? @constructor "^[A-Z]"))
(on_expression ifs: (name) @function)
(field_access field: (name) @property)
(field name: (label) @property)
(setting name: (label) @property)
(argument name: (label) @variable.parameter)
(measure (name) @property)

; Values.
(number) @number
(unit) @type.builtin
(text) @string
(escape_sequence) @string.escape

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
] @comment.documentation
