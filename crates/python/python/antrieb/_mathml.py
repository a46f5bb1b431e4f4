"""Formulas of derivations as MathML, read from their text: `ϑ_a + 40 · (P_cu + w · P_f)/P_0`."""

from __future__ import annotations

import re
from html import escape

_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")

_TOKEN = re.compile(
    r"\s*(?:(?P<number>\d+(?:[.,]\d+)?(?:e[-+]?\d+)?)"
    r"|(?P<name>[^\W\d_⁰¹²³⁴⁵⁶⁷⁸⁹](?:(?![⁰¹²³⁴⁵⁶⁷⁸⁹⁻])[\w′'])*)"
    r"|(?P<raised>[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]+)"
    r"|(?P<sign>[-+·/^()|;=<>≤≥−∫√∑*,%]))"
)


class _Unread(ValueError):
    """A text that is no formula."""


def math(text: str) -> str:
    """The formula as MathML; a text that is none as it is."""
    try:
        inside = _Reader(text).whole()
    except _Unread:
        return f"<span>{escape(text)}</span>"
    return f'<math alttext="{escape(text)}"><mrow>{inside}</mrow></math>'


class _Reader:
    """Reads a formula by its operators: sums, products, powers."""

    def __init__(self, text: str) -> None:
        self.tokens: list[tuple[str, str]] = []
        place, text = 0, text.strip()
        while place < len(text):
            found = _TOKEN.match(text, place)
            if found is None:
                raise _Unread(text)
            kind = found.lastgroup or ""
            self.tokens.append((kind, found.group(kind)))
            place = found.end()
        self.place = 0

    def whole(self) -> str:
        found = self.relation()
        if self.place < len(self.tokens):
            raise _Unread
        return found

    def peek(self) -> str:
        kind, text = self.tokens[self.place] if self.place < len(self.tokens) else ("", "")
        return text if kind == "sign" else ""

    def take(self, *signs: str) -> str | None:
        sign = self.peek()
        if sign and sign in signs:
            self.place += 1
            return sign
        return None

    def relation(self) -> str:
        found = self.sum()
        while sign := self.take("=", "<", ">", "≤", "≥"):
            found += f"<mo>{escape(sign)}</mo>{self.sum()}"
        return found

    def sum(self) -> str:
        first = self.take("−", "-", "+")
        found = (f'<mo form="prefix">{_minus(first)}</mo>' if first else "") + self.product()
        while sign := self.take("+", "−", "-"):
            found += f"<mo>{_minus(sign)}</mo>{self.product()}"
        return found

    def product(self) -> str:
        found = self.power()
        while sign := self.take("·", "*", "/"):
            right = self.power()
            if sign == "/":
                found = f"<mfrac><mrow>{_bare(found)}</mrow><mrow>{_bare(right)}</mrow></mfrac>"
            else:
                found += f"<mo>·</mo>{right}"
        return found

    def power(self) -> str:
        found = self.atom()
        while True:
            if self.take("^"):
                found = f"<msup><mrow>{found}</mrow><mrow>{_bare(self.atom())}</mrow></msup>"
            elif self.place < len(self.tokens) and self.tokens[self.place][0] == "raised":
                raised = self.tokens[self.place][1].translate(_RAISED).replace("-", "−")
                self.place += 1
                found = f"<msup><mrow>{found}</mrow><mn>{raised}</mn></msup>"
            else:
                return found

    def atom(self) -> str:
        if self.place >= len(self.tokens):
            raise _Unread
        kind, text = self.tokens[self.place]
        self.place += 1
        if kind == "number":
            return f"<mn>{text}</mn>"
        if kind == "name":
            return self.call(text) if self.peek() == "(" and "_" not in text and len(text) > 1 else _symbol(text)
        if text == "(":
            return f'<mrow><mo>(</mo>{self.list(")")}<mo>)</mo></mrow>'
        if text == "|":
            return f'<mrow><mo>|</mo>{self.list("|")}<mo>|</mo></mrow>'
        if text == "√":
            return f"<msqrt><mrow>{_bare(self.atom())}</mrow></msqrt>"
        if text in ("∫", "∑"):
            return f"<mo>{text}</mo>{self.power()}"
        raise _Unread(text)

    def call(self, name: str) -> str:
        self.place += 1
        return f'<mrow><mi>{escape(name)}</mi><mo>(</mo>{self.list(")")}<mo>)</mo></mrow>'

    def list(self, end: str) -> str:
        found = self.relation()
        while self.take(";"):
            found += f'<mo separator="true">;</mo>{self.relation()}'
        if self.take(end) is None:
            raise _Unread(end)
        return found


def _minus(sign: str) -> str:
    return "−" if sign == "-" else sign


def _bare(term: str) -> str:
    """A term without the parentheses that a fraction or a root makes superfluous."""
    head, tail = "<mrow><mo>(</mo>", "<mo>)</mo></mrow>"
    if not (term.startswith(head) and term.endswith(tail)):
        return term
    inside = term[len(head) : -len(tail)]
    # Only if the first parenthesis is closed by the last.
    depth = 0
    for found in re.finditer(r"<mo>([()])</mo>", inside):
        depth += 1 if found.group(1) == "(" else -1
        if depth < 0:
            return term
    return inside


def _symbol(name: str) -> str:
    head, _, index = name.partition("_")
    if not index:
        return f"<mi>{escape(head)}</mi>"
    return f"<msub><mi>{escape(head)}</mi><mtext>{escape(index.replace('_', ','))}</mtext></msub>"
