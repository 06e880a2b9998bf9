# SPDX-FileCopyrightText: 2026 The Cradle authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many mutants in one text: each beside what it changes, one of them chosen when the program starts.

a < b becomes (mutant::is(7) ? (a <= b) : (a < b)). So a file is compiled once for all its mutants. Every mutant has
a line of its own, FIRST_LINE + its number, by which the compiler tells which cannot be chosen so.
"""

import re

from mutant_tokens import TOKEN, closing

FIRST_LINE = 1_000_000

# MUTANT chooses one by its number; MUTANTS_REACHED names a file in which the place of each is 1 that was run.
HEADER = """#pragma once
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
namespace mutant {
inline const int chosen = std::getenv("MUTANT") ? std::atoi(std::getenv("MUTANT")) : 0;
inline char *const reached = [] {
    const char *const name = std::getenv("MUTANTS_REACHED");
    const int file = name ? ::open(name, O_RDWR) : -1;
    void *const bytes = file < 0 ? MAP_FAILED : ::mmap(nullptr, SIZE, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    return bytes == MAP_FAILED ? nullptr : static_cast<char *>(bytes);
}();
inline bool is(int number)
{
    if (reached)
        reached[number] = 1;
    return number == chosen;
}
}
"""

HEADERS_OF_BLOCKS = ("if", "for", "while", "switch", "constexpr")
BEFORE_EXPRESSIONS = ("return", "else", "do", "case", "throw", "delete", "co_return", "co_yield")
ASSIGNMENT = re.compile(r"(?<![=!<>+\-*/%&|^])(?:[-+*/%&|^]|<<|>>)?=(?!=)")
MATCHING = {"(": ")", "[": "]", "{": "}"}


def blanked(text):
    """Text without comments, strings and directives, as long as before."""
    pieces = list(text)
    for match in TOKEN.finditer(text):
        if match.group("skip") and not match.group().startswith(("<", "[[")):
            filler = " " if match.group().lstrip()[0] in "/#" else "S"
            for i in range(match.start(), match.end()):
                if pieces[i] != "\n":
                    pieces[i] = filler
    return "".join(pieces)


class Places:
    """Where in a source an expression begins and ends."""

    def __init__(self, text):
        self.plain = blanked(text)
        self.partner = {}  # of every bracket
        opened = []
        for i, letter in enumerate(self.plain):
            if letter in MATCHING:
                opened.append(i)
            elif opened and letter == MATCHING[self.plain[opened[-1]]]:
                self.partner[i] = opened.pop()
                self.partner[self.partner[i]] = i

    def word_before(self, i):
        return re.search(r"\w*$", self.plain[:i].rstrip()[-20:]).group()

    def begin(self, i, cuts):
        """Where the expression begins that holds \p i and no operator of \p cuts."""
        while i > 0:
            letter, two = self.plain[i - 1], self.plain[i - 2:i]
            if letter in "([{;,?" or two in cuts:
                break
            if letter == ":" and two != "::" and self.plain[i] != ":":
                break
            if letter == "=" and "=" in cuts and self.plain[i] != "=" and two not in ("==", "!=", "<=", ">="):
                break
            if letter in ")]}":
                if letter == "}" and re.match(r"[ ]*\n", self.plain[i:]):
                    break  # of a block
                opening = self.partner.get(i - 1, 0)
                if letter == ")" and self.word_before(opening) in HEADERS_OF_BLOCKS:
                    break
                i = opening
                continue
            if letter.isalpha() and not self.plain[i].isalnum() and self.word_before(i) in BEFORE_EXPRESSIONS:
                break
            i -= 1
        while self.plain[i].isspace():
            i += 1
        return i

    def end(self, i, cuts):
        """Where it ends."""
        while i < len(self.plain):
            letter, two = self.plain[i], self.plain[i:i + 2]
            if letter in ")]};," or two in cuts or (letter == "?" and "=" in cuts):
                break
            if letter == ":" and "=" in cuts and two != "::" and self.plain[i - 1] != ":":
                break
            if "=" in cuts and ASSIGNMENT.match(self.plain, i):
                break
            i = self.partner.get(i, i) + 1 if letter in MATCHING else i + 1
        while self.plain[i - 1].isspace():
            i -= 1
        return i

    def constants(self):
        """(begin, end, name) of every declaration of a constant."""
        for match in re.finditer(r"\bconstexpr [^;(){}=]*?(\w+)(?:\[\w*\])?\s*([={(])", self.plain):
            end = self.end(match.start(2), ())
            if self.plain[end:end + 1] == ";":  # no function
                yield match.start(), end, match.group(1)


def switched(places, text, mutant):
    """(begin, end, code of the mutant, code around both) of what a mutant has to be chosen for."""
    _, begin, end, replacement = mutant
    token = text[begin:end]
    if replacement.startswith("; /*"):
        return begin, end, "", "{{ if (mutant::is({number})) {{ {changed} }} else {{ {original} }} }}"
    if token.startswith("continue"):
        end = places.end(end, ()) + 1
        return begin, end, "break;", "{{ if (mutant::is({number})) {changed} else {original} }}"
    expression = "(mutant::is({number}) ? ({changed}) : ({original}))"
    if token[0].isdigit() or token[0] == "." or token in ("true", "false"):
        return begin, end, replacement, expression
    truth = "(mutant::is({number}) ? static_cast<bool>({changed}) : static_cast<bool>({original}))"
    if token[0] == "(":  # a whole condition
        return begin + 1, end - 1, replacement, truth
    cuts = ("=",) if token in ("&&", "||") else ("=", "&&", "||")
    if ASSIGNMENT.fullmatch(token):
        cuts = ()
    first, last = places.begin(begin, cuts), places.end(end, cuts)
    return first, last, text[first:begin] + replacement + text[end:last], truth if token == "!" else expression


def on_one_line(code):
    return re.sub(r"\s*\n\s*", " ", re.sub(r"//[^\n]*", "", code))


class SwitchedFile:
    """A source and those of its mutants that can be chosen when a program starts."""

    def __init__(self, name, text, numbered):
        self.name = name
        self.text = text
        self.places = Places(text)
        self.regions = {}  # {(begin, end, around): [(number, code of the mutant)]}
        for number, mutant in numbered.items():
            begin, end, changed, around = switched(self.places, text, mutant)
            if begin < end:
                self.regions.setdefault((begin, end, around), []).append((number, on_one_line(changed)))
        nested = []
        for region in sorted(self.regions, key=lambda r: (r[0], -r[1], "{{" not in r[2])):
            if any(begin < region[0] < end < region[1] for begin, end, _ in nested):
                del self.regions[region]
            else:
                nested.append(region)
        self.order = nested

    def numbers(self):
        return {number for mutants in self.regions.values() for number, _ in mutants}

    def drop(self, numbers, lines, names):
        """Leaves out mutants by their numbers, by lines that do not compile, and by names that have to be declared."""
        declares = re.compile(rf"[\w>*&] [*&]*(?:{'|'.join(names) or ' '})\b")
        fixed = [(begin, end) for begin, end, name in self.places.constants() if name in names]
        for region in self.order:
            begin, end, around = region
            if (lines & set(range(self.line(begin), self.line(end) + 1)) or any(b <= begin < e for b, e in fixed)
                    or ("{{" in around and declares.search(self.text[begin:end]))):
                del self.regions[region]
            else:
                self.regions[region] = [mutant for mutant in self.regions[region] if mutant[0] not in numbers]
        self.order = [region for region in self.order if self.regions.get(region)]

    def line(self, i):
        return self.text.count("\n", 0, i) + 1

    def code(self):
        text = self.text
        for begin, end, _ in self.places.constants():
            if any(begin <= region[0] < end for region in self.order):
                text = text[:begin] + "const    " + text[begin + len("constexpr"):]
        return self._rendered(text, 0, len(text), self.order)

    def _rendered(self, text, begin, end, regions):
        """Text from begin to end, in which the regions lie."""
        code = ""
        while regions:
            region, first, last = regions[0], regions[0][0], regions[0][1]
            inside = [other for other in regions[1:] if other[1] <= last]
            regions = regions[1 + len(inside):]
            original = self._line_mark(first) + self._rendered(text, first, last, inside)
            for number, changed in self.regions[region]:
                original = region[2].format(number=number, original=original,
                                            changed=f"\n#line {FIRST_LINE + number}\n{changed}\n")
            code += text[begin:first] + original + self._line_mark(last)
            begin = last
        return code + text[begin:end]

    def _line_mark(self, i):
        return f'\n#line {self.line(i)} "{self.name}"\n'
