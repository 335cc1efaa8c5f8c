; What Helix selects as one thing: `maf` a function or an ifs, `mat` a record or a fabricate block, `maT` a test,
; `maa` a parameter or an argument, `mac` a comment, `mae` an entry of a list or of braces.
(function_item value: (_) @function.inside) @function.around
(ifs_item body: (ifs_body) @function.inside) @function.around

(record_item body: (record_body) @class.inside) @class.around
(fabricate_item body: (fabricate_body) @class.inside) @class.around

(test_item body: (test_body) @test.inside) @test.around

((parameter) @parameter.inside . ","? @parameter.around) @parameter.around
((control_point) @parameter.inside . ","? @parameter.around) @parameter.around
(arguments ((_) @parameter.inside . ","? @parameter.around) @parameter.around)

(setting value: (_) @entry.inside) @entry.around
(field) @entry.around
(list ((_) @entry.inside . ","? @entry.around) @entry.around)

[
  (comment)
  (doc_comment)
  (file_doc_comment)
] @comment.inside

(comment)+ @comment.around
(doc_comment)+ @comment.around
