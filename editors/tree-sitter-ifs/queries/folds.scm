; What can be folded: every pair of brackets over several lines, items that are long, and comments in a row.
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
] @fold

(use_item)+ @fold
(comment)+ @fold
(doc_comment)+ @fold
(file_doc_comment)+ @fold
