# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/mutate changes of a source: one token or statement at a time."""

import re
import sys

TOKEN = re.compile(r"""
    (?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#[^\n]*|R"(\w*)\((?:.|\n)*?\)\2"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'
        |<[\w:]+(?:<[\w:, *]+>)?[ ]?[*&]?>(?=[(\s{,)>]|$)|\[\[\w+\]\])
  | (?P<number>(?<![\w.])(?:\d[\d']*\.?\d*(?:[eE][-+]?\d+)?|\.\d+)[uUlLfF]*(?![\w.]))
  | (?P<word>[A-Za-z_]\w*)
  | (?P<op><=>|<<=?|>>=?|->|\+\+|--|[-+*/]=|&&|\|\||[=!<>]=|::|[-+*/<>!?])
""", re.X | re.M | re.S)

SWAPS = {
    "<": ["<=", ">"], "<=": ["<"], ">": [">=", "<"], ">=": [">"], "==": ["!="], "!=": ["=="],
    "&&": ["||"], "||": ["&&"], "+=": ["-="], "-=": ["+="], "*=": ["/="], "/=": ["*="],
    "++": ["--"], "--": ["++"], "min": ["max"], "max": ["min"], "true": ["false"], "false": ["true"],
    "floor": ["ceil"], "ceil": ["floor"], "sin": ["cos"], "cos": ["sin"], "continue": ["break"],
}
BINARY = {"+": "-", "-": "+", "*": "/", "/": "*"}
STATEMENT = re.compile(r"^[ ]{4,}(?!\.|return|const |auto |case |default|break|continue|else|using |static |\}|\{)"
                       r"[\w:>.\[\]()*-]+[^;{}\n]*(?:\(|=|\+\+|--)[^;{}\n]*;[ ]*(?://.*)?$", re.M)
# What it declares is used.
DECLARATION = re.compile(r"(?!emit |delete |throw )(?:const )?[A-Za-z_][\w:]*(?:<[^=;()]*>)?(?: [&*]*|[&*]+ )"
                         r"(?:\w+|\[[\w, ]+\]) ?[=({\[](?!=)")

# Only saves time, or is not compiled at all.
NO_MUTANT = re.compile(r"; /\* (?:[\w.>\-\[\]()]*reserve\(|Q_ASSERT)")


def number_swaps(text):
    digits = text.rstrip("uUlLfF")
    value = float(digits.replace("'", ""))
    if "e" in digits.lower():  # a tolerance: what it is exactly is taste, its order is not
        return [f"({text} * 10)", f"({text} * 0.1)"]
    if "." in digits:
        return ["1.0"] if value == 0 else [f"({text} * 1.5)", f"({text} * 0.5)"]
    return [f"({text} + 1)"]


def mutants_of(text, first=1, last=sys.maxsize):
    """(line, begin, end, replacement) of every mutant of \\p text between two lines."""
    found = []

    def add(begin, end, replacement):
        line = text.count("\n", 0, begin) + 1
        if first <= line <= last and not NO_MUTANT.match(replacement):
            found.append((line, begin, end, replacement))

    before = ""
    for match in TOKEN.finditer(text):
        token, kind = match.group(), match.lastgroup
        if kind == "skip":
            continue
        if kind == "number":
            for other in number_swaps(token):
                add(match.start(), match.end(), other)
        elif token in SWAPS and not (token in "<>" and template_bracket(text, match)):
            for other in SWAPS[token]:
                add(match.start(), match.end(), other)
        elif token in BINARY and text[match.start() - 1:match.start()] == " " == text[match.end():match.end() + 1]:
            add(match.start(), match.end(), BINARY[token])
        elif token == "!":
            add(match.start(), match.end(), "")
        elif token == "if" and before != "else":
            opening = text.index("(", match.end())
            close = closing(text, opening)
            condition = text[opening + 1:close]
            if ";" not in condition and not DECLARATION.match(condition):
                add(opening, close + 1, f"(({condition}) && false)")
                add(opening, close + 1, f"(({condition}) || true)")
        before = token
    for match in STATEMENT.finditer(text):
        if DECLARATION.match(match.group().strip()):
            continue
        begin = match.start() + len(match.group()) - len(match.group().lstrip())
        end = text.index(";", begin) + 1
        add(begin, end, f"; /* {text[begin:end]} */")
    return found


def template_bracket(text, match):
    """Whether < or > belongs to a template: comparisons stand between spaces."""
    return not (text[match.start() - 1] == " " and text[match.end():match.end() + 1] in " \n")


def closing(text, opening):
    depth = 0
    for i in range(opening, len(text)):
        depth += {"(": 1, ")": -1}.get(text[i], 0)
        if depth == 0:
            return i
    return opening


def changed_line(text, mutant):
    line, begin, end, replacement = mutant
    start = text.rfind("\n", 0, begin) + 1
    stop = text.find("\n", end)
    return " ".join((text[start:begin] + replacement + text[end:stop]).split())
