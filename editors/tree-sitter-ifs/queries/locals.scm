; Scopes: the file, each ifs, function and test, and each list that runs over a range.
[
  (source_file)
  (ifs_item)
  (function_item)
  (test_body)
  (transform_member)
  (comprehension)
] @local.scope

(param_item name: (name) @local.definition)
(let_item name: (name) @local.definition)
(let_member name: (name) @local.definition)
(parameter name: (label) @local.definition)
(control_point name: (name) @local.definition)
(for_clause name: (name) @local.definition)
(family name: (name) @local.definition)
(imported_names (name) @local.definition)

(name) @local.reference
