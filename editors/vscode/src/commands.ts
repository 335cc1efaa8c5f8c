// The commands: what they do to the design in the editor, or to the one a code lens names.

import { createHash } from "node:crypto";
import * as fs from "node:fs";
import * as path from "node:path";
import * as vscode from "vscode";
import { program } from "./program";

/** Builds a design in a task, whose terminal shows what the program says. Gives whether it was built. */
export async function build(uri?: string | vscode.Uri): Promise<boolean> {
  const design = await saved(uri);
  return design !== undefined && run(design, []);
}

/** Shows the report of a design beside it. It is made anew, in the extension's own folder: no output of the design changes. */
export async function showReport(storage: vscode.Uri, uri?: string | vscode.Uri): Promise<void> {
  const design = await saved(uri);
  if (!design) return;
  const folder = await made(storage, design, "", ["--emit", "html"]);
  if (folder) await showPage(`Report of ${path.basename(design.fsPath, ".ifs")}`, path.join(folder, "report.html"));
}

/** Makes the outputs of one figure in the extension's own folder, and shows those that are chosen. */
export async function preview(storage: vscode.Uri, uri?: string | vscode.Uri, figure?: string): Promise<void> {
  const design = await saved(uri);
  if (!design) return;
  const folder = await made(storage, design, figure ?? "", figure ? ["--only", `${figure}*`] : []);
  if (!folder) return;
  const entries = await fs.promises.readdir(folder, { recursive: true, withFileTypes: true });
  const files = entries.filter((entry) => entry.isFile()).map((entry) => path.join(entry.parentPath ?? entry.path, entry.name));
  const names = files.map((file) => path.relative(folder, file)).sort();
  const placeHolder = `Outputs of ${figure ?? path.basename(design.fsPath)}: which one?`;
  const chosen = await vscode.window.showQuickPick(names, { placeHolder });
  if (!chosen) return;
  const file = path.join(folder, chosen);
  if (/\.(html|svg)$/.test(chosen)) await showPage(chosen, file);
  else await vscode.commands.executeCommand("vscode.open", vscode.Uri.file(file), vscode.ViewColumn.Beside);
}

/** Outputs of a design in a folder of the extension's own, one for each `part` of it; nothing where it cannot be built. */
async function made(storage: vscode.Uri, design: vscode.Uri, part: string, options: string[]): Promise<string | undefined> {
  const name = createHash("sha256").update(`${design.fsPath}\n${part}`).digest("hex").slice(0, 16);
  const folder = path.join(storage.fsPath, name);
  await fs.promises.mkdir(storage.fsPath, { recursive: true });
  if (await run(design, [...options, "--out", folder])) return folder;
  void vscode.window.showErrorMessage("There is nothing to show, since the design cannot be built: the terminal says why.");
  return undefined;
}

/** Shows a page or a drawing beside the text. */
async function showPage(title: string, file: string): Promise<void> {
  const text = await fs.promises.readFile(file, "utf8");
  const panel = vscode.window.createWebviewPanel("ifs.report", title, vscode.ViewColumn.Beside, { enableScripts: true });
  panel.webview.html = text;
}

/** Runs `ifs build` on a design and waits for its end. */
async function run(design: vscode.Uri, options: string[]): Promise<boolean> {
  const name = path.basename(design.fsPath);
  const process = new vscode.ProcessExecution(program(), ["build", name, ...options], { cwd: path.dirname(design.fsPath) });
  const scope = vscode.workspace.getWorkspaceFolder(design) ?? vscode.TaskScope.Workspace;
  const task = new vscode.Task({ type: "ifs" }, scope, `build ${name}`, "ifs", process, []);
  task.presentationOptions = { reveal: vscode.TaskRevealKind.Always, clear: true };
  const ended = new Promise<number | undefined>((resolve) => {
    const listener = vscode.tasks.onDidEndTaskProcess((end) => {
      if (end.execution.task.name !== task.name) return;
      listener.dispose();
      resolve(end.exitCode);
    });
  });
  await vscode.tasks.executeTask(task);
  return (await ended) === 0;
}

/** The design meant, with what was typed in it saved. */
async function saved(uri?: string | vscode.Uri): Promise<vscode.Uri | undefined> {
  const active = vscode.window.activeTextEditor?.document;
  const meant = typeof uri === "string" ? vscode.Uri.parse(uri) : uri instanceof vscode.Uri ? uri : active?.uri;
  if (!meant || meant.scheme !== "file" || !meant.fsPath.endsWith(".ifs")) {
    void vscode.window.showErrorMessage("Open a design (.ifs) first.");
    return undefined;
  }
  const document = vscode.workspace.textDocuments.find((document) => document.uri.toString() === meant.toString());
  if (document?.isDirty && !(await document.save())) return undefined;
  return meant;
}
