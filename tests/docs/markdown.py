"""A page of Markdown in parts: its links, its anchors, its code."""

import re


class Page:
    """`code`: lines of blocks, and spans, with their line numbers. `blocks`: (line, text) of each block, a fence included.
    `headings_at`: (line, title). `prose`: the text with all code blanked, the same length."""

    def __init__(self, text):
        self.text, self.code, self.blocks = text, [], []
        self.prose = re.sub(r"^( *)(```+|~~~+).*?^ *\2[^\n]*$", self._block, text, flags=re.M | re.S)
        self.prose = re.sub(r"(?:(?<=\n\n)|(?<=\A))(?: {4,}\S[^\n]*(?:\n+(?= {4,}\S)|\n|\Z))+", self._block, self.prose)
        self.headings_at = [(self.line_of(match.start()), match[1]) for match in re.finditer(r"^#{1,6} +(.+?) *#*$", self.prose, re.M)]
        self.prose = re.sub(r"(?<!`)(`+)(?!`)((?:(?!\n\n).)+?)(?<!`)\1(?!`)", self._span, self.prose, flags=re.S)

    def _block(self, match):
        self.blocks.append((self.line_of(match.start()), match[0]))
        for offset, line in joined_lines(match[0]):
            self.code.append((self.line_of(match.start() + offset), line))
        return re.sub(r"[^\n]", " ", match[0])

    def _span(self, match):
        self.code.append((self.line_of(match.start()), " ".join(match[2].split())))
        return re.sub(r"[^\n]", "x", match[0])

    def line_of(self, offset):
        return self.text.count("\n", 0, offset) + 1

    def links(self):
        """(line, target) of each link and picture."""
        for match in re.finditer(r"\]\(\s*<?([^()\s>]+(?:\([^()\s]*\)[^()\s>]*)?)>?(?:\s+\"[^\"]*\")?\s*\)", self.prose):
            yield self.line_of(match.start()), match[1]
        for match in re.finditer(r"<(?:img|a)\s[^>]*(?:src|href)=\"([^\"]+)\"", self.prose):
            yield self.line_of(match.start()), match[1]

    def anchors(self):
        """As GitHub makes them of headings: lower case, no punctuation, blanks to hyphens, a number behind the second of a name."""
        found = {}
        for _, heading in self.headings_at:
            words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")
            slug = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
            found[slug] = found.get(slug, -1) + 1
            yield f"{slug}-{found[slug]}" if found[slug] else slug
        yield from re.findall(r"<a (?:id|name)=\"([^\"]+)\"", self.prose)


def joined_lines(block):
    """(offset, line): a line that ends with a backslash, or is followed by a line that goes on with options, is one with it."""
    start, line, offset = 0, "", 0
    for part in block.splitlines(keepends=True):
        if line and (line.endswith("\\") or re.match(r" {5,}\[?--?\w| {5,}\[-", part)):
            line = line.removesuffix("\\") + " " + part.strip()
        else:
            if line:
                yield start, line
            start, line = offset, part.rstrip("\n")
        offset += len(part)
    if line:
        yield start, line
