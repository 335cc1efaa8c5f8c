; Indents in the words of Helix: one step inside brackets, and one for a value below the `=` of its item.
[
  (imported_names)
  (parameters)
  (record_body)
  (control_points)
  (ifs_body)
  (fabricate_body)
  (test_body)
  (points)
  (arguments)
  (group)
  (tuple)
  (list)
  (comprehension)
  (fields)
  (function_item)
  (figure_item)
  (let_item)
  (let_member)
  (transform_member)
  (boundary_member)
] @indent

[
  ")"
  "]"
  "}"
] @outdent
