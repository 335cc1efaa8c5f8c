// The extension: starts `ifs lsp`, and carries out the commands. What the editor shows of a design comes from the server.

import * as vscode from "vscode";
import { LanguageClient, ServerOptions } from "vscode-languageclient/node";
import { build, preview, showReport } from "./commands";
import { program } from "./program";

let client: LanguageClient | undefined;
/** The program that was started last. */
let started: string | undefined;
/** Starts and restarts, one after the other. */
let turn: Promise<void> = Promise.resolve();

/** Called by the editor when a design is opened. */
export async function activate(context: vscode.ExtensionContext): Promise<void> {
  context.subscriptions.push(
    vscode.commands.registerCommand("ifs.build", (uri) => build(uri)),
    vscode.commands.registerCommand("ifs.showReport", (uri) => showReport(context.globalStorageUri, uri)),
    vscode.commands.registerCommand("ifs.preview", (uri, figure) => preview(context.globalStorageUri, uri, figure)),
    vscode.commands.registerCommand("ifs.restart", restart),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("ifs.server") && program() !== started) void restart();
    }),
  );
  await restart();
}

/** Called by the editor at its end. */
export async function deactivate(): Promise<void> {
  await client?.dispose();
}

async function start(): Promise<void> {
  const command = program();
  started = command;
  // No transport is named: the client would add `--stdio`.
  const server: ServerOptions = { command, args: ["lsp"] };
  client = new LanguageClient("ifs", "ifs", server, {
    documentSelector: [
      { scheme: "file", language: "ifs" },
      { scheme: "file", pattern: "**/ifs.toml" },
    ],
    // The server puts only those above a design that are said here.
    initializationOptions: { commands: ["ifs.build", "ifs.showReport", "ifs.preview"] },
  });
  try {
    await client.start();
  } catch (reason) {
    const said = `The ifs server does not start: \`${command} lsp\` (${String(reason)}). Install ifs, or say where it is.`;
    void vscode.window.showErrorMessage(said, "Open Settings").then((choice) => {
      if (choice) void vscode.commands.executeCommand("workbench.action.openSettings", "ifs.server.path");
    });
  }
}

function restart(): Promise<void> {
  turn = turn.then(async () => {
    const old = client;
    client = undefined;
    await old?.dispose().catch(() => undefined);
    await start();
  });
  return turn;
}
