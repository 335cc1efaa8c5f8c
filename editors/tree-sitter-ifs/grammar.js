/**
 * @file The grammar of ifs for editors: colours, folds and indents while a text is being typed.
 *
 * The language itself is defined by the compiler's parser (compiler/src/syntax). A test holds this grammar to it on
 * every .ifs file of the repository. What is here is how a text is put together; the case of names, the closed list
 * of measures, sizes of numbers and depth of brackets are for the compiler to judge.
 *
 * Line ends never matter, and entries of blocks need no commas, so the word before a `:` is what tells where an entry
 * ends: `label` is a token of its own, found by src/scanner.c, as are numbers with the unit that is glued to them.
 */

/// <reference types="tree-sitter-cli/dsl" />
// @ts-check

/** How tightly operators bind, as in compiler/src/syntax/parser/operators.rs. */
const PRECEDENCE = {
  condition: -1,
  placement: 0,
  or: 1,
  and: 2,
  not: 3,
  compare: 4,
  range: 5,
  by: 6,
  add: 7,
  multiply: 8,
  negate: 9,
  postfix: 10,
};

/** Elements between commas, of which the last may have one too. */
const elements = (rule) => optional(seq(rule, repeat(seq(",", rule)), optional(",")));

/** Entries of a block: a comma after each is optional. */
const block = (rule) => seq("{", repeat(seq(rule, optional(","))), "}");

module.exports = grammar({
  name: "ifs",

  word: ($) => $.name,

  externals: ($) => [$.label, $.number, $._digits, $.unit],

  extras: ($) => [/[ \t\r\n\f]/, $.comment, $.doc_comment, $.file_doc_comment],

  supertypes: ($) => [$.item, $.member, $.type],

  inline: ($) => [$._initial_value],

  rules: {
    source_file: ($) => repeat($.item),

    item: ($) =>
      choice(
        $.use_item,
        $.param_item,
        $.let_item,
        $.function_item,
        $.record_item,
        $.ifs_item,
        $.figure_item,
        $.fabricate_item,
        $.test_item,
      ),

    // Comments.
    comment: (_) => token(choice(/\/\/([^/!\n][^\n]*)?/, /\/\/\/\/[^\n]*/)),
    doc_comment: (_) => token(/\/\/\/([^/\n][^\n]*)?/),
    file_doc_comment: (_) => token(/\/\/![^\n]*/),

    // Items.
    visibility: (_) => "pub",

    use_item: ($) =>
      seq(
        optional($.visibility),
        "use",
        field("module", choice($.module_path, $.text)),
        field("names", $.imported_names),
      ),
    module_path: ($) => seq($.name, repeat(seq(".", $.name))),
    imported_names: ($) => seq("(", elements($.name), ")"),

    param_item: ($) =>
      seq(
        optional($.visibility),
        "param",
        field("name", $.name),
        ":",
        field("type", $.type),
        "=",
        field("value", $._value),
        optional(seq("in", field("range", $.limit_range))),
        optional(seq("step", field("step", $._value))),
      ),

    let_item: ($) => seq(optional($.visibility), $._binding),
    let_member: ($) => $._binding,
    _binding: ($) => seq("let", field("name", $.name), optional(seq(":", field("type", $.type))), $._initial_value),
    _initial_value: ($) => seq("=", field("value", $._value)),

    function_item: ($) =>
      seq(
        optional($.visibility),
        "fn",
        field("name", $.name),
        field("parameters", $.parameters),
        optional(seq("->", field("result", $.type))),
        $._initial_value,
      ),
    parameters: ($) => seq("(", elements($.parameter), ")"),
    parameter: ($) =>
      seq(field("name", $.label), ":", field("type", $.type), optional(seq("=", field("default", $._value)))),

    record_item: ($) => seq(optional($.visibility), "record", field("name", $.name), field("body", $.record_body)),
    record_body: ($) => block($.field),
    field: ($) =>
      seq(field("name", $.label), ":", field("type", $.type), optional(seq("=", field("default", $._value)))),

    figure_item: ($) =>
      seq(
        optional($.visibility),
        "figure",
        field("name", $.name),
        optional(seq(":", field("type", $.type))),
        $._initial_value,
      ),

    // An ifs and its members.
    ifs_item: ($) =>
      seq(
        optional($.visibility),
        "ifs",
        field("name", $.name),
        field("parameters", optional($.parameters)),
        field("space", choice($.control_points, $.affine_space)),
        field("body", $.ifs_body),
      ),
    control_points: ($) => seq("on", "(", elements($.control_point), ")"),
    control_point: ($) =>
      seq(field("name", $.name), optional(seq("[", field("count", $._value), optional(","), "]"))),
    affine_space: (_) => seq("in", choice("plane", "space")),
    ifs_body: ($) => block($.member),

    member: ($) =>
      choice($.let_member, $.transform_member, $.germ_member, $.keep_member, $.boundary_member, $.join_member),
    transform_member: ($) =>
      seq("transform", field("name", $.name), field("family", optional($.family)), $._initial_value),
    family: ($) => seq("[", field("name", $.name), "in", field("range", $._value), "]"),
    germ_member: ($) => seq("germ", field("value", $._value)),
    keep_member: ($) => seq("keep", field("value", $._value)),
    boundary_member: ($) => seq("boundary", field("name", $.name), $._initial_value),
    join_member: ($) => seq("join", field("left", $.boundary_path), "=", field("right", $.boundary_path)),
    boundary_path: ($) => seq($._boundary_part, optional(seq(".", $._boundary_part))),
    _boundary_part: ($) => seq($.name, optional(seq("[", $._value, optional(","), "]"))),

    // Fabrication.
    fabricate_item: ($) =>
      seq(
        optional($.visibility),
        "fabricate",
        field("figure", $.name),
        "as",
        field("kind", $.name),
        field("body", $.fabricate_body),
      ),
    fabricate_body: ($) => block(choice($.setting, $.requirement)),
    setting: ($) => seq(field("name", $.label), ":", field("value", $._value)),
    requirement: ($) => seq("require", field("measure", $.measure), $._limit),
    measure: ($) => repeat1($.name),
    _limit: ($) =>
      choice(
        seq(field("comparison", $.comparison_operator), field("limit", $._sum)),
        seq("in", field("limit", $.limit_range)),
      ),
    limit_range: ($) => seq(field("from", $._sum), "..", field("to", $._sum)),
    comparison_operator: (_) => choice("==", "!=", "<", "<=", ">", ">="),

    // Tests.
    test_item: ($) => seq(optional($.visibility), "test", field("name", $.text), field("body", $.test_body)),
    test_body: ($) => block(choice($.let_member, $.assertion)),
    assertion: ($) => seq("assert", field("condition", $._value)),

    // Types.
    type: ($) => choice($.type_name, $.list_type),
    type_name: ($) => $.name,
    list_type: ($) => seq("[", $.type, "]"),

    // Expressions, from the loosest to the tightest: placements, logic, comparisons, ranges, sums, operands.
    // A whole one ends as late as it can: `if c then a else b + 1` adds to b.
    _value: ($) => prec(PRECEDENCE.condition, $._placed),

    _placed: ($) => choice($.on_expression, $.level_expression, $.until_expression, $._row),
    on_expression: ($) =>
      seq(field("ifs", $._placed), "on", field("placement", choice($.points, $._row))),
    points: ($) => prec(1, seq("(", elements($._value), ")")),
    level_expression: ($) => seq(field("figure", $._placed), "at", "level", field("level", $._sum)),
    until_expression: ($) =>
      seq(field("figure", $._placed), optional("each"), "until", field("measure", $.measure), $._limit),

    _row: ($) => choice($.or_expression, $.and_expression, $._negatable),
    or_expression: ($) => prec.left(PRECEDENCE.or, seq(field("left", $._row), "or", field("right", $._row))),
    and_expression: ($) => prec.left(PRECEDENCE.and, seq(field("left", $._row), "and", field("right", $._row))),
    _negatable: ($) => choice($.not_expression, $.comparison, $._comparable),
    not_expression: ($) => prec(PRECEDENCE.not, seq("not", field("operand", $._negatable))),
    comparison: ($) =>
      prec(
        PRECEDENCE.compare,
        seq(field("left", $._comparable), field("operator", $.comparison_operator), field("right", $._comparable)),
      ),
    _comparable: ($) => choice($.range, $._sum),
    range: ($) => prec(PRECEDENCE.range, seq(field("from", $._sum), "..", field("to", $._sum))),

    _sum: ($) => choice($.binary_expression, $._operand),
    binary_expression: ($) =>
      choice(
        ...[
          [PRECEDENCE.by, "by"],
          [PRECEDENCE.add, choice("+", "-")],
          [PRECEDENCE.multiply, choice("*", "/")],
        ].map(([precedence, operator]) =>
          prec.left(
            precedence,
            seq(field("left", $._sum), field("operator", operator), field("right", $._sum)),
          ),
        ),
      ),

    _operand: ($) => choice($.negation, $._postfix),
    negation: ($) => prec(PRECEDENCE.negate, seq("-", field("operand", $._operand))),

    _postfix: ($) => choice($.call, $.index, $.field_access, $._primary),
    call: ($) => prec(PRECEDENCE.postfix, seq(field("function", $._postfix), field("arguments", $.arguments))),
    arguments: ($) => seq("(", elements($.argument), ")"),
    argument: ($) => seq(optional(seq(field("name", $.label), ":")), field("value", $._value)),
    index: ($) => prec(PRECEDENCE.postfix, seq(field("list", $._postfix), "[", elements($._value), "]")),
    field_access: ($) => prec(PRECEDENCE.postfix, seq(field("record", $._postfix), ".", field("field", $.name))),

    _primary: ($) =>
      choice(
        $.number,
        $.quantity,
        $.text,
        $.boolean,
        $.self,
        $.name,
        $.group,
        $.tuple,
        $.list,
        $.comprehension,
        $.fields,
        $.condition,
      ),

    quantity: ($) => seq(alias($._digits, $.number), $.unit),
    boolean: (_) => choice("true", "false"),
    self: (_) => "self",
    group: ($) => seq("(", $._value, optional(","), ")"),
    tuple: ($) => seq("(", $._value, repeat1(seq(",", $._value)), optional(","), ")"),
    list: ($) => seq("[", elements($._value), "]"),
    comprehension: ($) =>
      seq("[", field("element", $._value), $.for_clause, repeat(choice($.for_clause, $.if_clause)), "]"),
    for_clause: ($) => seq("for", field("name", $.name), "in", field("range", $._value)),
    if_clause: ($) => seq("if", field("condition", $._value)),
    fields: ($) => block($.setting),
    condition: ($) =>
      prec.right(
        PRECEDENCE.condition,
        seq("if", field("condition", $._value), "then", field("yes", $._value), "else", field("no", $._value)),
      ),

    // Words.
    text: ($) =>
      seq(
        '"',
        repeat(choice(alias(token.immediate(prec(1, /[^"\\\n]+/)), $.text_content), $.escape_sequence)),
        token.immediate('"'),
      ),
    escape_sequence: (_) => token.immediate(prec(1, /\\["\\nt]/)),
    name: (_) => /[A-Za-z_][A-Za-z0-9_]*/,
  },
});
