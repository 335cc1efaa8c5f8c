"""Parses files with the tree-sitter grammar of editors/, and compiles all queries there.

grammar.py LIBRARY FOLDER_OF_QUERIES FILE...

Prints one line: which files have ERROR or MISSING nodes, and how many captures each query has over all files.
Ends with 1 where a query does not compile.
"""

import ctypes
import json
import pathlib
import sys

from tree_sitter import Language, Parser, Query, QueryCursor


def language(library):
    function = ctypes.cdll.LoadLibrary(library).tree_sitter_ifs
    function.restype = ctypes.c_void_p
    capsule = ctypes.pythonapi.PyCapsule_New
    capsule.restype = ctypes.py_object
    capsule.argtypes = [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]
    return Language(capsule(function(), b"tree_sitter.Language", None))


def main():
    library, queries, *files = sys.argv[1:]
    ifs = language(library)
    parser = Parser(ifs)
    compiled, faults = {}, []
    for path in sorted(pathlib.Path(queries).rglob("*.scm")):
        name = path.relative_to(queries).as_posix()
        if "node_modules" in name:
            continue
        try:
            compiled[name] = Query(ifs, path.read_text())
        except Exception as fault:
            faults.append(f"{name}: {fault}")
    captures = dict.fromkeys(compiled, 0)
    wrong = []
    for file in files:
        tree = parser.parse(pathlib.Path(file).read_bytes())
        if tree.root_node.has_error:
            wrong.append(file)
        for name, query in compiled.items():
            captures[name] += sum(map(len, QueryCursor(query).captures(tree.root_node).values()))
    print(json.dumps({"wrong": wrong, "captures": captures}))
    print("\n".join(faults), file=sys.stderr)
    sys.exit(1 if faults else 0)


main()
