"""Reads Coq sources as Coq does: as sentences made of tokens, not as lines.

Comments nest, and a string within a comment hides what it holds; both are gone when sentences come
out.  What Coq and this reader might take differently is refused rather than guessed.
"""

import re
from dataclasses import dataclass

IDENTIFIER = r"[A-Za-z_][A-Za-z0-9_']*"
TOKEN = re.compile(rf"{IDENTIFIER}(?:\.{IDENTIFIER})*|[0-9][0-9_.]*(?<!\.)|:=|:>|\|-|=>|->|<-|#\[|\.\.\.?"
                   r"|[-+*]+|[^\s\w]")
COMMENT_PART = re.compile(r'\(\*|\*\)|"[^"]*"')
STRING = re.compile(r'"(?:[^"]|"")*"')
BULLETS = re.compile(r"[-+*]+|[{}]")


class Unreadable(Exception):
    """A source file that is not plainly a list of sentences."""


@dataclass(frozen=True)
class Sentence:
    line: int
    tokens: tuple  # identifiers (qualified ones whole), numbers, strings with their quotes, symbols

    def __str__(self):
        return " ".join(self.tokens)

    @property
    def words(self):
        """The tokens without the bullets, braces and goal selectors before a tactic."""
        rest = list(self.tokens)
        while rest and BULLETS.fullmatch(rest[0]):
            rest.pop(0)
        while len(rest) > 1 and rest[1] == ":" and (rest[0] in ("all", "par") or rest[0].isdigit()):
            del rest[:2]
        return tuple(rest)


def skip_comment(text, start):
    """The position after the comment that begins at start."""
    depth, at = 1, start + 2
    while depth:
        part = COMMENT_PART.search(text, at)
        if not part:
            raise Unreadable("a comment has no end")
        at = part.end()
        depth += {"(*": 1, "*)": -1}.get(part.group(), 0)
    return at


def tokens(text):
    """Pairs of a position and a token; the dot that ends a sentence is None."""
    at = 0
    while at < len(text):
        if text[at].isspace():
            at += 1
            continue
        if text.startswith("(*", at):
            at = skip_comment(text, at)
            continue
        found = STRING.match(text, at) if text[at] == '"' else TOKEN.match(text, at)
        if not found or not found.group().isascii():
            raise Unreadable(f"line {line_of(text, at)}: a character out of place: {text[at]!r}")
        token, end = found.group(), found.end()
        if token in (".", "..."):
            if end < len(text) and not text[end].isspace():
                raise Unreadable(f"line {line_of(text, at)}: a dot that may or may not end a sentence")
            yield at, None
        else:
            yield at, token
        at = end


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def sentences(path):
    """The sentences of a file, in order; raises Unreadable."""
    text = path.read_bytes().decode("utf-8", "surrogateescape")
    found, current, first = [], [], 0
    for at, token in tokens(text):
        if token is None:
            found.append(Sentence(line_of(text, first), tuple(current)))
            current = []
        else:
            first = first if current else at
            current.append(token)
    if current:
        raise Unreadable(f"line {line_of(text, first)}: a sentence has no end")
    return found
