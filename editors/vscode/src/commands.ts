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
  const folder = path.join(storage.fsPath, createHash("sha256").update(design.fsPath).digest("hex").slice(0, 16));
  await fs.promises.mkdir(storage.fsPath, { recursive: true });
  if (!(await run(design, ["--emit", "html", "--out", folder]))) {
    void vscode.window.showErrorMessage("There is no report, since the design cannot be built: the terminal says why.");
    return;
  }
  const name = path.basename(design.fsPath, ".ifs");
  const panel = vscode.window.createWebviewPanel("ifs.report", `Report of ${name}`, vscode.ViewColumn.Beside, {
    enableScripts: true,
  });
  panel.webview.html = await fs.promises.readFile(path.join(folder, "report.html"), "utf8");
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
