//! `ifs params`: the parameters of a design, as a table for people or as JSON for programs.

use ifs_compiler::analysis::parameters::{ParameterInfo, ParameterWords, parameter_infos};
use serde::Serialize;

use super::{Messages, tell};
use crate::args::{MessageFormat, Params};
use crate::exit::Exit;
use crate::output;
use crate::project::{Analysed, Project};

/// Prints the parameters of a design; nothing else of it is worked out.
pub fn params(params: &Params, format: MessageFormat) -> Exit {
    let messages = Messages::beside_data(format);
    let project = match Project::open(&params.file, messages) {
        Ok(project) => project,
        Err(exit) => return exit,
    };
    let Analysed { analysis, sources, exit } = project.read(&params.settings, messages);
    if exit != Exit::Good {
        return exit;
    }
    let (infos, found) = parameter_infos(&analysis, &project.overrides(&params.settings));
    let told = tell(&found, &sources, messages);
    let text = if params.json { json(&infos) } else { table(&infos) };
    told.exit.max(output::data(&text).err().unwrap_or(Exit::Good))
}

/// A line each, in columns, the names first.
fn table(infos: &[ParameterInfo]) -> String {
    if infos.is_empty() {
        return "the design has no parameters\n".to_owned();
    }
    let head = ["name", "type", "value", "default", "range", "step", ""].map(str::to_owned);
    let mut rows = vec![head];
    for info in infos {
        let range = info
            .range
            .as_ref()
            .map_or_else(String::new, |(from, to)| format!("{} .. {}", from.text, to.text));
        let step = info.step.as_ref().map_or_else(String::new, |step| step.text.clone());
        let docs = info.docs.iter().map(|line| line.trim()).find(|line| !line.is_empty()).unwrap_or("");
        let (value, default) = (info.value.text.clone(), info.default.text.clone());
        rows.push([info.name.clone(), info.ty.clone(), value, default, range, step, docs.to_owned()]);
    }
    let widths: Vec<usize> =
        (0..6).map(|column| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0)).collect();
    let mut text = String::new();
    for row in &rows {
        let mut line = String::new();
        for (cell, width) in row.iter().zip(&widths) {
            line.push_str(cell);
            line.push_str(&" ".repeat(width + 2 - cell.chars().count().min(*width)));
        }
        line.push_str(&row[6]);
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

#[derive(Serialize)]
struct JsonValue<'a> {
    text: &'a str,
    number: Option<f64>,
}

#[derive(Serialize)]
struct JsonParameter<'a> {
    name: &'a str,
    #[serde(rename = "type")]
    ty: &'a str,
    unit: &'a str,
    default: JsonValue<'a>,
    value: JsonValue<'a>,
    min: Option<JsonValue<'a>>,
    max: Option<JsonValue<'a>>,
    step: Option<JsonValue<'a>>,
    doc: String,
}

fn json(infos: &[ParameterInfo]) -> String {
    fn value(words: &ParameterWords) -> JsonValue<'_> {
        JsonValue { text: &words.text, number: words.number }
    }
    let parameters: Vec<JsonParameter<'_>> = infos
        .iter()
        .map(|info| JsonParameter {
            name: &info.name,
            ty: &info.ty,
            unit: info.unit,
            default: value(&info.default),
            value: value(&info.value),
            min: info.range.as_ref().map(|(from, _)| value(from)),
            max: info.range.as_ref().map(|(_, to)| value(to)),
            step: info.step.as_ref().map(value),
            doc: info.docs.iter().map(|line| line.trim()).collect::<Vec<_>>().join("\n"),
        })
        .collect();
    serde_json::to_string_pretty(&parameters).map(|text| text + "\n").unwrap_or_default()
}
