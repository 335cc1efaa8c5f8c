//! The commands of an editor's extension that lenses may name. A client says which it has, since one that is not there
//! would be an error at the click.

use serde_json::Value;

/// What a client can carry out, as it said in its initialization options: `{ "commands": ["ifs.build"] }`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Commands {
    pub(crate) build: bool,
    pub(crate) show_report: bool,
    pub(crate) preview: bool,
}

/// Writes the outputs of a design; its argument is the design's URI.
pub(crate) const BUILD: &str = "ifs.build";
/// Shows the report of a design; its argument is the design's URI.
pub(crate) const SHOW_REPORT: &str = "ifs.showReport";
/// Shows the outputs of one figure; its arguments are the design's URI and the figure's name.
pub(crate) const PREVIEW: &str = "ifs.preview";

impl Commands {
    /// Those that the initialization options name.
    pub(crate) fn of(options: Option<&Value>) -> Commands {
        let named = options.and_then(|options| options.get("commands")).and_then(Value::as_array);
        let has = |name: &str| named.is_some_and(|named| named.iter().any(|known| known == name));
        Commands { build: has(BUILD), show_report: has(SHOW_REPORT), preview: has(PREVIEW) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_is_not_named_is_not_there() {
        let some = json!({ "commands": ["ifs.build", "other.build", 3] });
        assert_eq!(Commands::of(Some(&some)), Commands { build: true, ..Commands::default() });
        for none in [json!(null), json!([]), json!({ "commands": "ifs.build" }), json!({ "ifs.build": true })]
        {
            assert_eq!(Commands::of(Some(&none)), Commands::default(), "{none}");
        }
        assert_eq!(Commands::of(None), Commands::default());
    }
}
