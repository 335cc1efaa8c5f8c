"""Helix opens a design with a mistake, in a terminal of its own: what is wrong, under which word; hover, definition,
completion, a fix, a rename, the layout, indents, text objects and colours. Run by tests/editors.sh:

    helix.py PROGRAM FOLDER PICTURE

PROGRAM starts Helix as it is set up, FOLDER takes the design, PICTURE the last screen as text. Ends with 1 at the first
thing that does not come."""

import pathlib
import sys
import time

import pexpect
import pyte

LINES, COLUMNS = 45, 130
ESCAPE, ENTER = "\x1b", "\r"


class Helix:
    """Helix and what it shows."""

    def __init__(self, program, file):
        self.screen = pyte.Screen(COLUMNS, LINES)
        self.stream = pyte.ByteStream(self.screen)
        self.child = pexpect.spawn(program, [str(file)], dimensions=(LINES, COLUMNS), timeout=None)

    def look(self, seconds=0.2):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                self.stream.feed(self.child.read_nonblocking(65536, timeout=0.05))
            except pexpect.TIMEOUT:
                pass

    def text(self):
        return "\n".join(self.screen.display)

    def keys(self, *keys):
        for key in keys:
            # Letter by letter, as people write: changes of one moment may be sent in a wrong order by Helix 25.01.
            for letter in key:
                self.child.send(letter)
                self.look(0.04)
            self.look(0.15)

    def wait(self, what, shown, seconds=20):
        """Until `shown`, a text or a test of the screen, is there."""
        if isinstance(shown, str):
            words = shown
            shown = lambda: words in self.text()
        end = time.monotonic() + seconds
        while not shown():
            if time.monotonic() > end:
                sys.exit(f"Helix: {what} did not come; it shows\n{self.text()}")
            self.look()
        print(f"Helix: {what}")

    def place(self, word):
        """Line and column of the first place where the screen has the word."""
        for line, text in enumerate(self.screen.display):
            if word in text:
                return line, text.index(word)
        sys.exit(f"Helix: no {word} in\n{self.text()}")

    def style(self, word, offset=0):
        line, column = self.place(word)
        return self.screen.buffer[line][column + offset]

    def search(self, word):
        """Goes to the next place of a word and leaves it selected."""
        self.keys("/", word, ENTER)


def main(program, folder, picture):
    root = pathlib.Path(__file__).resolve().parents[2]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    design = folder / "vault.ifs"
    text = (root / "examples/vault.ifs").read_text().replace("0.1 * span", "0.1 * spann")
    assert "spann" in text
    design.write_text(text)
    helix = Helix(program, design)
    helix.wait("the design is open", "param span")
    try:
        session(helix, design)
    finally:
        pathlib.Path(picture).write_text(helix.text() + "\n")
        helix.child.close(force=True)


def session(helix, design):
    keyword, comment, number = helix.style("param span"), helix.style("//!"), helix.style("27mm")
    colours = {keyword.fg, comment.fg, number.fg}
    if len(colours) < 3:
        sys.exit(f"Helix: a keyword, a comment and a number have the colours {colours}")
    print("Helix: colours by the grammar")

    helix.keys("]d")
    helix.wait("the mistake is told", "there is no `spann`")
    under = helix.style("spann,", 1)
    selected = helix.style("* spann", 1)
    if under.underscore == selected.underscore and under.fg == selected.fg and under.bg == selected.bg:
        sys.exit(f"Helix: the misspelt word looks like what is beside it: {under}")
    print("Helix: the misspelt word is marked")

    helix.keys(" ", "a")
    helix.wait("its fix is offered", "replace `spann` with `span`")
    helix.keys(ENTER)
    helix.wait("the fix is made", lambda: "spann" not in helix.text())

    helix.keys("gg")
    helix.search("width, rise")
    helix.keys("gd")
    helix.wait("the definition is found", lambda: helix.screen.cursor.y == helix.place("param rise")[0])
    helix.keys(" ", "k")
    helix.wait("the hover tells type and value", "Length")
    helix.keys(ESCAPE)

    helix.keys(" ", "r")
    helix.wait("a new name is asked for", "rename-to:")
    helix.keys("\x15", "height", ENTER)
    helix.wait("the parameter has another name", lambda: "param height" in helix.text() and "height * 4/3" in helix.text())

    helix.search("let width")
    helix.keys("O", "let tall: Length = wid")
    before = design.read_text().count("width")
    helix.wait("completion offers a name", lambda: helix.text().count("width") > before)
    helix.keys("\x0e", ENTER, ESCAPE)
    helix.wait("what was chosen is written", "let tall: Length = width")

    helix.search("as planks \\{")
    helix.keys("o", "side:centred", ESCAPE)
    helix.wait("a line in braces is indented", "    side:centred")
    helix.keys("x", "d")

    helix.keys("gg")
    helix.search("bezier3\\(t")
    helix.keys("m", "a", "f", "d")
    helix.wait("a function is one thing", lambda: "fn arch" not in helix.text())
    helix.keys("u")
    helix.wait("it is there again", "fn arch")

    helix.keys("gg")
    helix.search("param height: ")
    helix.keys("c", "param    height:", ESCAPE)
    helix.wait("a line is laid out badly", "param    height:")
    helix.keys(":format", ENTER)
    helix.wait("the layout is the compiler's", lambda: "param    height:" not in helix.text())
    helix.keys(":write", ENTER)
    right = ["param height: Length", "let tall: Length = width", "height * 4/3", "0.1 * span,"]
    helix.wait("what is written is right", lambda: all(words in design.read_text() for words in right))


if __name__ == "__main__":
    main(*sys.argv[1:])
