//! The command line: what may be asked of the program. Nothing is done here.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use ifs_compiler::hir::evaluate::MachineName;

/// What else can be set, and what wins.
const SETTINGS: &str = "\
The file ifs.toml marks the folder of a project and may set for all its designs:
  out = \"made\"      the folder, in the project, in which each design has its output folder
  machine = \"machines.ifs:router\"   a file of the project and a machine in it, in the place of those of designs
  [params]           below it, values of parameters: span = \"7m\"
Variables of the environment set the same: IFS_OUT, IFS_MACHINE, and IFS_PARAM_SPAN=7m for the parameter `span`.
An argument wins over a variable, that over ifs.toml, that over the design's own default.";

/// A compiler for free-form timber: from a design in equations to models, lists and machine programs.
#[derive(Debug, Clone, PartialEq, Parser)]
#[command(name = "ifs", version, about, disable_help_subcommand = true, after_help = SETTINGS)]
pub struct Cli {
    /// How diagnostics are printed
    #[arg(long, global = true, value_enum, value_name = "FORMAT", default_value_t = MessageFormat::Human)]
    pub message_format: MessageFormat,

    /// What to do.
    #[command(subcommand)]
    pub command: Command,
}

/// What the program does.
#[derive(Debug, Clone, PartialEq, Subcommand)]
pub enum Command {
    /// Print all diagnostics of designs; write nothing
    Check(Check),
    /// Build a design's outputs
    Build(Build),
    /// Lay out the text of designs
    Fmt(Fmt),
    /// Run the tests of designs
    Test(Test),
    /// Read an output folder again and say what is wrong with it
    Verify(Verify),
    /// Print the parameters of a design
    Params(Params),
    /// Print the documentation of the standard library
    Doc(Doc),
    /// Explain a diagnostic code
    Explain(Explain),
    /// Serve editors: the language server on standard input and output
    Lsp(Lsp),
}

/// `ifs lsp`.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct Lsp {
    /// Over standard input and output, which is the only way: many editors say it
    #[arg(long)]
    pub stdio: bool,
}

/// `ifs check`.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct Check {
    /// Design files; `-` is the standard input
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,

    /// Give a parameter another value; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub settings: Vec<Setting>,
}

/// `ifs build`.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct Build {
    /// The design file; `-` is the standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,

    /// The output folder; else one of the design's name in IFS_OUT, in the `out` of ifs.toml, or in `out/`
    #[arg(short = 'o', long = "out", value_name = "DIR")]
    pub out: Option<PathBuf>,

    /// Give a parameter another value; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub settings: Vec<Setting>,

    /// The machine that cuts, in the place of those the design names: a file of the project and the name of a machine in
    /// it, as in machines.ifs:router; else IFS_MACHINE, or the `machine` of ifs.toml
    #[arg(long, value_name = "FILE:NAME")]
    pub machine: Option<NamedMachine>,

    /// Make only these outputs, separated by commas; all files where it is not given
    #[arg(long, value_enum, value_delimiter = ',', value_name = "OUTPUT")]
    pub emit: Vec<Emit>,

    /// Make programs, drawings, list rows and labels only of boards whose address or alias fits; `*` stands for any
    /// characters, `?` for one; may be repeated
    #[arg(long, value_name = "PATTERN")]
    pub only: Vec<String>,

    /// Print diagnostics and nothing else: no line of progress on the terminal, no table of what was made
    #[arg(short, long)]
    pub quiet: bool,
}

/// `ifs fmt`.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct Fmt {
    /// Write nothing, name the files that are not laid out, and end with 1 if there are any
    #[arg(long)]
    pub check: bool,

    /// Write nothing, print what would change, and end with 1 if anything would
    #[arg(long)]
    pub diff: bool,

    /// Files, which are changed in place; `-` is the standard input, laid out on the standard output
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
}

/// `ifs test`.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct Test {
    /// Design files; `-` is the standard input
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,

    /// Give a parameter another value; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub settings: Vec<Setting>,
}

/// `ifs verify`.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct Verify {
    /// The output folder of a build
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,

    /// Also build this design again, with the parameters, the machine and the choice of outputs that the folder was built
    /// with, and compare all files byte by byte
    #[arg(long, value_name = "DESIGN")]
    pub source: Option<PathBuf>,
}

/// `ifs params`.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct Params {
    /// The design file; `-` is the standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,

    /// As JSON, for programs
    #[arg(long)]
    pub json: bool,

    /// Give a parameter another value; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub settings: Vec<Setting>,
}

/// `ifs doc`.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct Doc {
    /// A module or an item: curves, bezier3, std.curves.bezier3; all modules where it is not given
    #[arg(value_name = "ITEM")]
    pub item: Option<String>,

    /// The whole library as one page of Markdown
    #[arg(long, conflicts_with = "item")]
    pub markdown: bool,
}

/// `ifs explain`.
#[derive(Debug, Clone, PartialEq, Args)]
pub struct Explain {
    /// The code of a diagnostic, as it is printed: E0101
    #[arg(value_name = "CODE")]
    pub code: String,
}

/// How diagnostics are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum MessageFormat {
    /// With the source text, for people
    Human,
    /// One line each
    Short,
    /// One JSON object a line, for programs: on stdout, and on stderr where a command prints data of its own (fmt, params)
    Json,
}

/// An output that can be asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub enum Emit {
    /// The model, model.glb
    Glb,
    /// Machine programs, boards/*.nc, and of nested sheets, sheets/*.nc
    Nc,
    /// Drawings of boards, boards/*.dxf, and of nested sheets, sheets/*.dxf
    Dxf,
    /// Parts for timber machines, model.btlx
    Btlx,
    /// Lists: cutlist.csv, assembly.csv, nest.csv, stock.csv, planarity.csv
    Csv,
    /// Labels with QR codes, labels.svg, and pictures of nested sheets, sheets/*.svg
    Svg,
    /// The report for people, report.html
    Html,
    /// The report for programs, report.json
    Json,
    /// The plan, printed on the standard output
    Plan,
}

/// A parameter's value from outside: `span=7m`. The value is text in the language; the compiler reads it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Setting {
    /// The parameter's name.
    pub name: String,
    /// Its value, as written.
    pub value: String,
}

/// A machine of a file: `machines.ifs:router`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedMachine {
    /// The file, from the working folder.
    pub file: PathBuf,
    /// The name of the machine in it.
    pub name: String,
}

impl std::str::FromStr for NamedMachine {
    type Err = String;

    fn from_str(text: &str) -> Result<NamedMachine, String> {
        let (file, name) = MachineName::split(text)
            .ok_or("a machine is a file, `:` and a name in it, as in machines.ifs:router")?;
        Ok(NamedMachine { file: PathBuf::from(file), name: name.to_owned() })
    }
}

impl std::str::FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Setting, String> {
        let Some((name, value)) = text.split_once('=') else {
            return Err("a setting is a name, `=` and a value, as in span=7m".to_owned());
        };
        let (name, value) = (name.trim(), value.trim());
        let begins = name.starts_with(|c: char| c.is_ascii_lowercase() || c == '_');
        if !begins || !name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_') {
            return Err(format!(
                "`{name}` is not the name of a parameter: those are snake_case, as in span=7m"
            ));
        }
        if value.is_empty() {
            return Err(format!("`{name}` has no value: write it after the `=`, as in span=7m"));
        }
        Ok(Setting { name: name.to_owned(), value: value.to_owned() })
    }
}

impl Cli {
    /// Reads the arguments and checks what clap cannot: no parameter is set twice.
    ///
    /// # Errors
    /// Wrong usage; also the texts of `--help` and `--version`, which clap hands back the same way.
    pub fn read(arguments: impl IntoIterator<Item = std::ffi::OsString>) -> Result<Cli, clap::Error> {
        let cli = Cli::try_parse_from(arguments)?;
        let settings = match &cli.command {
            Command::Check(check) => check.settings.as_slice(),
            Command::Build(build) => build.settings.as_slice(),
            Command::Test(test) => test.settings.as_slice(),
            Command::Params(params) => params.settings.as_slice(),
            Command::Fmt(_)
            | Command::Verify(_)
            | Command::Doc(_)
            | Command::Explain(_)
            | Command::Lsp(_) => &[],
        };
        for (index, setting) in settings.iter().enumerate() {
            if settings[..index].iter().any(|earlier| earlier.name == setting.name) {
                let text = format!("the parameter `{}` is set twice\n", setting.name);
                return Err(clap::Error::raw(clap::error::ErrorKind::ArgumentConflict, text));
            }
        }
        Ok(cli)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(line: &str) -> Result<Cli, clap::Error> {
        Cli::read(line.split_whitespace().map(std::ffi::OsString::from))
    }

    #[test]
    fn the_declaration_is_sound() {
        <Cli as clap::CommandFactory>::command().debug_assert();
    }

    #[test]
    fn build_takes_what_the_page_says() {
        let cli = read(
            "ifs build a.ifs -o out/a --set span=7m --set rise=2*1m --emit glb,nc --message-format json",
        );
        let cli = cli.unwrap();
        assert_eq!(cli.message_format, MessageFormat::Json);
        let Command::Build(build) = cli.command else { panic!("not build") };
        assert_eq!(build.file, PathBuf::from("a.ifs"));
        assert_eq!(build.out, Some(PathBuf::from("out/a")));
        assert_eq!(build.emit, [Emit::Glb, Emit::Nc]);
        assert_eq!(build.settings[1], Setting { name: "rise".into(), value: "2*1m".into() });
    }

    #[test]
    fn the_server_takes_what_editors_say_by_habit() {
        let stdio = |line| matches!(read(line).unwrap().command, Command::Lsp(Lsp { stdio: true }));
        assert!(stdio("ifs lsp --stdio"));
        assert!(!stdio("ifs lsp"));
    }

    #[test]
    fn check_takes_several_files() {
        let Command::Check(check) = read("ifs --message-format short check a.ifs - b.ifs").unwrap().command
        else {
            panic!("not check")
        };
        assert_eq!(check.files.len(), 3);
    }

    #[test]
    fn fmt_takes_both_flags() {
        let Command::Fmt(fmt) = read("ifs fmt --check a.ifs --diff - b.ifs").unwrap().command else {
            panic!("not fmt")
        };
        assert!(fmt.check && fmt.diff);
        assert_eq!(fmt.files.len(), 3);
    }

    #[test]
    fn wrong_usage_is_told() {
        for (line, part) in [
            ("ifs", "Usage"),
            ("ifs check", "FILE"),
            ("ifs fmt --check", "FILE"),
            ("ifs build a.ifs b.ifs", "b.ifs"),
            ("ifs build a.ifs --emit png", "png"),
            ("ifs build a.ifs --set span", "a name, `=` and a value"),
            ("ifs build a.ifs --set Span=1", "snake_case"),
            ("ifs build a.ifs --set =1", "snake_case"),
            ("ifs build a.ifs --set span=", "no value"),
            ("ifs build a.ifs --set a=1 --set a=2", "set twice"),
            ("ifs chekc a.ifs", "check"),
        ] {
            let error = read(line).unwrap_err();
            assert_eq!(error.exit_code(), 2, "{line}");
            assert!(error.to_string().contains(part), "{line}: {error}");
        }
    }
}
