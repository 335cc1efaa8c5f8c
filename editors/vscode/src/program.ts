// Which ifs program is run.

import * as vscode from "vscode";

/** The program of the settings: a name on the PATH or a path; `~` is the person's home. */
export function program(): string {
  const path = vscode.workspace.getConfiguration("ifs").get<string>("server.path")?.trim() || "ifs";
  return path.startsWith("~/") ? `${process.env.HOME ?? "~"}${path.slice(1)}` : path;
}
