// The tokens of ifs that are known only by what follows them: a label is a name before `:`, and a number ends with the
// longest unit of the table that no letter, digit or `_` follows. As compiler/src/syntax/lexer/number.rs and
// lexeme.rs read them. The scanner has no state.

#include "tree_sitter/parser.h"

#include <string.h>

// The order of `externals` in grammar.js.
enum Token { LABEL, NUMBER, DIGITS_BEFORE_UNIT, UNIT };

// Words that are never labels: the reserved words of compiler/src/syntax/token.rs.
static const char *const RESERVED[] = {
    "use", "pub", "param", "let", "fn", "record", "ifs", "figure", "fabricate", "test",
    "if", "then", "else", "for", "in", "on", "at", "self", "true", "false",
};

// The units of compiler/src/syntax/unit.rs.
static const char *const UNITS[] = {
    "mm", "cm", "m", "in", "ft", "m2", "mm2", "m3", "mm3", "deg", "rad", "s", "min", "rpm",
    "mm/min", "m/min", "mm/s", "m/s", "kg", "kg/m3", "%",
};

#define COUNT(table) (sizeof(table) / sizeof((table)[0]))
#define LONGEST_UNIT 6
#define LONGEST_RESERVED 9

static bool is_digit(int32_t c) { return c >= '0' && c <= '9'; }

static bool is_letter(int32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

static bool is_space(int32_t c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f'; }

// Whether a word goes on with this character; letters outside ASCII do, of which the lexer complains.
static bool continues_word(int32_t c) { return is_letter(c) || is_digit(c) || c >= 0x80; }

static void advance(TSLexer *lexer) { lexer->advance(lexer, false); }

static void digits(TSLexer *lexer) {
    while (is_digit(lexer->lookahead)) advance(lexer);
}

// Reads the longest unit here. `mark` says whether the token is to end with it. Gives false where there is none; then
// `*glued` says whether something else is glued to the digits.
static bool unit(TSLexer *lexer, bool mark, bool *glued) {
    char read[LONGEST_UNIT + 1] = {0};
    size_t length = 0;
    bool found = false;
    *glued = continues_word(lexer->lookahead) || lexer->lookahead == '%';
    while (length < LONGEST_UNIT && lexer->lookahead > ' ' && lexer->lookahead < 0x80) {
        read[length++] = (char)lexer->lookahead;
        advance(lexer);
        for (size_t i = 0; i < COUNT(UNITS); i++) {
            if (strcmp(read, UNITS[i]) == 0 && !continues_word(lexer->lookahead)) {
                found = true;
                if (mark) lexer->mark_end(lexer);
            }
        }
    }
    return found;
}

// `12`, `0.46`, `1e3`: plain, or before a unit.
static bool number(TSLexer *lexer, const bool *valid) {
    digits(lexer);
    lexer->mark_end(lexer);
    bool glued = false;
    if (lexer->lookahead == '.') {
        advance(lexer);
        if (!is_digit(lexer->lookahead)) {
            // `0..7` or `0.field`: the digits end before the dot.
            lexer->result_symbol = NUMBER;
            return valid[NUMBER];
        }
        digits(lexer);
        lexer->mark_end(lexer);
    }
    if (lexer->lookahead == 'e' || lexer->lookahead == 'E') {
        advance(lexer);
        if (lexer->lookahead == '+' || lexer->lookahead == '-') advance(lexer);
        // No unit begins with `e`, so without digits this is a word that is glued to the number.
        if (!is_digit(lexer->lookahead)) return false;
        digits(lexer);
        lexer->mark_end(lexer);
    }
    if (unit(lexer, false, &glued)) {
        lexer->result_symbol = DIGITS_BEFORE_UNIT;
        return valid[DIGITS_BEFORE_UNIT];
    }
    lexer->result_symbol = NUMBER;
    return !glued && valid[NUMBER];
}

// Passes over space and comments between a name and its colon.
static void trivia(TSLexer *lexer) {
    for (;;) {
        while (is_space(lexer->lookahead)) advance(lexer);
        if (lexer->lookahead != '/') return;
        advance(lexer);
        if (lexer->lookahead != '/') return;
        while (lexer->lookahead != '\n' && !lexer->eof(lexer)) advance(lexer);
    }
}

// A name that a `:` follows.
static bool label(TSLexer *lexer) {
    char read[LONGEST_RESERVED + 2] = {0};
    size_t length = 0;
    while (is_letter(lexer->lookahead) || is_digit(lexer->lookahead)) {
        if (length <= LONGEST_RESERVED) read[length++] = (char)lexer->lookahead;
        advance(lexer);
    }
    for (size_t i = 0; i < COUNT(RESERVED); i++) {
        if (strcmp(read, RESERVED[i]) == 0) return false;
    }
    lexer->mark_end(lexer);
    trivia(lexer);
    lexer->result_symbol = LABEL;
    return lexer->lookahead == ':';
}

void *tree_sitter_ifs_external_scanner_create(void) { return NULL; }

void tree_sitter_ifs_external_scanner_destroy(void *payload) { (void)payload; }

unsigned tree_sitter_ifs_external_scanner_serialize(void *payload, char *buffer) {
    (void)payload;
    (void)buffer;
    return 0;
}

void tree_sitter_ifs_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
    (void)payload;
    (void)buffer;
    (void)length;
}

bool tree_sitter_ifs_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid) {
    (void)payload;
    bool glued = false;
    // A unit is valid alone, but for the search after an error, where everything is.
    if (valid[UNIT] && !valid[LABEL]) {
        lexer->result_symbol = UNIT;
        return unit(lexer, true, &glued);
    }
    while (is_space(lexer->lookahead)) lexer->advance(lexer, true);
    if (is_digit(lexer->lookahead)) return number(lexer, valid);
    return valid[LABEL] && is_letter(lexer->lookahead) && label(lexer);
}
