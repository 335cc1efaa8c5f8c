"""A terminal for one program: `python terminal.py COLUMNS PROGRAM ARGUMENT…`.

Runs the program with stderr on a pseudo-terminal of so many columns and stdout in a pipe, and plays what comes on the
terminal: carriage returns and line feeds move, everything else is written over what stands there. Prints one line of
JSON: the exit code, what came on stdout, every different state the last line had, what stands on the screen at the
end, and which control characters beside those two came. Exit code 0; what is right is for the caller to say.
"""

import fcntl
import json
import os
import pty
import struct
import subprocess
import sys
import termios


def played(text, columns):
    """The lines of the screen, every state of a line that was drawn, and control characters that are not understood."""
    lines, column, states, strange = [[]], 0, [], set()
    for character in text:
        if character == "\r":
            states.append("".join(lines[-1]))
            column = 0
        elif character == "\n":
            lines.append([])
            column = 0
        elif character < " " or character == "\x7f":
            strange.add(repr(character))
        else:
            if column == columns:
                lines.append([])
                column = 0
            line = lines[-1]
            line.extend(" " * (column + 1 - len(line)))
            line[column] = character
            column += 1
    different = [state.rstrip() for place, state in enumerate(states) if place == 0 or states[place - 1] != state]
    return ["".join(line).rstrip() for line in lines], different, sorted(strange)


def main(columns, command):
    master, slave = pty.openpty()
    fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
    environment = dict(os.environ, TERM="xterm")
    child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=slave, env=environment)
    os.close(slave)
    seen = b""
    while True:
        try:
            piece = os.read(master, 4096)
        except OSError:  # the program has let go of the terminal
            break
        if not piece:
            break
        seen += piece
    out = child.stdout.read().decode()
    # The terminal itself makes a line feed a carriage return with a line feed.
    screen, states, strange = played(seen.decode().replace("\r\n", "\n"), columns)
    verdict = {"code": child.wait(), "stdout": out, "states": states, "screen": screen, "strange": strange}
    print(json.dumps(verdict))
    return 0


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit("usage: python terminal.py COLUMNS PROGRAM ARGUMENT…")
    sys.exit(main(int(sys.argv[1]), sys.argv[2:]))
