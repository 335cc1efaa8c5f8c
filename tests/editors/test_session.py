"""A session of pytest-lsp's client with `ifs lsp`, over a copy of an example in IFS_FOLDER; the program is IFS_PROGRAM."""

import os
import pathlib
import sys

import pytest_lsp
from lsprotocol import types
from pytest_lsp import ClientServerConfig, LanguageClient, client_capabilities

FOLDER = pathlib.Path(os.environ["IFS_FOLDER"])
DESIGN = FOLDER / "vault.ifs"
URI = DESIGN.as_uri()

watched = []


@pytest_lsp.fixture(config=ClientServerConfig(server_command=[os.environ["IFS_PROGRAM"], "lsp"]))
async def client(lsp_client: LanguageClient):
    params = types.InitializeParams(
        capabilities=client_capabilities("visual-studio-code"),
        workspace_folders=[types.WorkspaceFolder(uri=FOLDER.as_uri(), name="designs")],
    )

    # The client says that it can do this, and leaves it to the test.
    @lsp_client.feature(types.CLIENT_REGISTER_CAPABILITY)
    def register(params: types.RegistrationParams):
        watched.extend(registration.method for registration in params.registrations)

    for refresh in (types.WORKSPACE_CODE_LENS_REFRESH, types.WORKSPACE_INLAY_HINT_REFRESH):
        lsp_client.feature(refresh)(lambda *_: None)

    await lsp_client.initialize_session(params)
    yield lsp_client
    await lsp_client.shutdown_session()


def place(text: str, word: str, plus: int = 0) -> types.Position:
    before = text[: text.index(word) + plus]
    return types.Position(line=before.count("\n"), character=len(before) - before.rfind("\n") - 1)


async def test_a_design_is_opened_changed_and_asked_about(client: LanguageClient):
    text = DESIGN.read_text()
    document = types.TextDocumentIdentifier(uri=URI)
    client.text_document_did_open(
        types.DidOpenTextDocumentParams(types.TextDocumentItem(uri=URI, language_id="ifs", version=1, text=text))
    )

    pulled = await client.text_document_diagnostic_async(types.DocumentDiagnosticParams(text_document=document))
    assert [item for item in pulled.items if item.severity == types.DiagnosticSeverity.Error] == []

    at = place(text, "rise * 4/3")
    hover = await client.text_document_hover_async(types.HoverParams(text_document=document, position=at))
    assert "Length" in hover.contents.value and "2.6m" in hover.contents.value, hover

    found = await client.text_document_definition_async(types.DefinitionParams(text_document=document, position=at))
    assert found.uri == URI and found.range.start == place(text, "rise: Length")

    uses = await client.text_document_references_async(
        types.ReferenceParams(
            text_document=document, position=at, context=types.ReferenceContext(include_declaration=True)
        )
    )
    assert len(uses) == text.count("rise ") + text.count("rise:")

    symbols = await client.text_document_document_symbol_async(types.DocumentSymbolParams(text_document=document))
    assert {"span", "rise", "arch", "vault"} <= {symbol.name for symbol in symbols}

    start = place(text, "rise * 4/3")
    wrong = types.TextDocumentContentChangePartial(
        range=types.Range(start=start, end=types.Position(start.line, start.character + 4)), text="rose"
    )
    client.text_document_did_change(
        types.DidChangeTextDocumentParams(
            text_document=types.VersionedTextDocumentIdentifier(uri=URI, version=2), content_changes=[wrong]
        )
    )
    pulled = await client.text_document_diagnostic_async(types.DocumentDiagnosticParams(text_document=document))
    errors = [item for item in pulled.items if item.severity == types.DiagnosticSeverity.Error]
    assert [(item.code, item.range.start) for item in errors] == [("E0301", start)]
    assert "rise" in errors[0].message, "the right name is offered"

    assert watched == [types.WORKSPACE_DID_CHANGE_WATCHED_FILES]

    known = [types.PreviousResultId(uri=URI, value=pulled.result_id)]
    whole = await client.workspace_diagnostic_async(types.WorkspaceDiagnosticParams(previous_result_ids=known))
    kinds = {pathlib.PurePosixPath(item.uri).name: item.kind for item in whole.items}
    assert kinds == {"vault.ifs": "unchanged", "shell.ifs": "full"}, kinds


if __name__ == "__main__":
    import pytest

    options = ["-q", "-p", "no:cacheprovider", "-o", "asyncio_mode=auto", "--rootdir", os.environ["IFS_FOLDER"]]
    sys.exit(pytest.main([__file__, *options]))
