//! The variables of the environment that set something: `IFS_OUT`, `IFS_MACHINE`, and `IFS_PARAM_` with a parameter's name in capitals.

use std::collections::BTreeMap;
use std::path::PathBuf;

/// What the names of variables that set parameters begin with.
const PARAMETER: &str = "IFS_PARAM_";

/// `IFS_OUT`: the folder in which each design has its output folder.
pub fn out() -> Option<PathBuf> {
    std::env::var_os("IFS_OUT").filter(|value| !value.is_empty()).map(PathBuf::from)
}

/// `IFS_MACHINE`: the file and name of the machine that cuts; one that is not UTF-8 is none.
pub fn machine() -> Option<String> {
    std::env::var("IFS_MACHINE").ok().filter(|value| !value.is_empty())
}

/// Where programs keep what they can make again: `XDG_CACHE_HOME`, else `.cache` at home; the system's own place elsewhere.
pub fn cache() -> Option<PathBuf> {
    let named = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    named("XDG_CACHE_HOME").or_else(|| named("LOCALAPPDATA")).or_else(|| Some(named("HOME")?.join(".cache")))
}

/// The parameters that are set, each with its value and the words for where it comes from. A value that is not UTF-8 is
/// none of the language.
pub fn parameters() -> BTreeMap<String, (String, String)> {
    let set = std::env::vars_os().filter_map(|(name, value)| {
        let name = name.to_str()?;
        let parameter = name.strip_prefix(PARAMETER).filter(|rest| !rest.is_empty())?.to_lowercase();
        let value = value.to_string_lossy().into_owned();
        Some((parameter, (value, format!("the variable `{name}`"))))
    });
    set.collect()
}
