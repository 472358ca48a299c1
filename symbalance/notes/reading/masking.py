"""What of a document is not to be read as mathematics: blanked, so that every offset stays."""

from __future__ import annotations

import re
from collections.abc import Iterator

_WIDE = {0xFF01 + k: 0x21 + k for k in range(94)} | {0x3000: 0x20, 0x0D: 0x20, 0xA0: 0x20}
_WIDE |= dict.fromkeys(
    (*range(9), 0x0B, 0x0C, *range(0x0E, 0x20), 0x7F, 0xFEFF, 0x200B, 0x200C, 0x200D, 0x2060), 0x20
)
_COMMENT = re.compile(r"(?<!\\)(?:\\\\)*(%[^\n]*)")
_VERBATIM = re.compile(r"\\begin\s*\{(verbatim\*?|lstlisting|minted|comment|Verbatim)\}")
_VERB = re.compile(r"\\verb\*?([^A-Za-z\s*])[^\n]{0,400}?\1")
_ADDRESS = re.compile(
    r"[A-Za-z][A-Za-z0-9+.-]{1,20}://[^\s<>\"「」、。]+|[\w.+-]{1,64}@[\w-]{1,64}(?:\.[\w-]{1,64})+"
)
_FENCE = re.compile(r"[ ]{0,3}(`{3,}|~{3,})\s*([A-Za-z]*)")
_BOLD = re.compile(r"(?<![\w)*])\*\*(?=[^\s*])([^*\n]{1,300})(?<=\S)\*\*(?![\w(*])")
_CODE = re.compile(r"(`+)(?!`)[^`\n]{1,400}\1(?!`)")


def blanked(text: str) -> str:
    """Return as many spaces, with the line ends where they were."""
    return "".join("\n" if c == "\n" else " " for c in text) if "\n" in text else " " * len(text)


def narrowed(text: str) -> str:
    """Return the text with full-width signs as plain ones, of the same length."""
    return text.translate(_WIDE)


def mask_tex(text: str) -> str:
    """Blank comments, verbatim, the preamble and what follows the end."""
    text = _COMMENT.sub(lambda m: m.group()[: m.start(1) - m.start()] + blanked(m.group(1)), text)
    text = _without_environments(text)
    text = _VERB.sub(lambda m: blanked(m.group()), text)
    begin = text.find("\\begin{document}")
    if begin >= 0:
        begin += len("\\begin{document}")
        text = blanked(text[:begin]) + text[begin:]
    end = text.find("\\end{document}")
    return text if end < 0 else text[:end] + blanked(text[end:])


def _without_environments(text: str) -> str:
    pieces: list[str] = []
    place = 0
    while found := _VERBATIM.search(text, place):
        closer = f"\\end{{{found.group(1)}}}"
        end = text.find(closer, found.end())
        end = len(text) if end < 0 else end + len(closer)
        pieces += [text[place : found.start()], blanked(text[found.start() : end])]
        place = end
    return "".join([*pieces, text[place:]])


def mask_plain(text: str) -> str:
    """Blank addresses of the net and of mail."""
    return _ADDRESS.sub(lambda m: blanked(m.group()), text)


def mask_markdown(text: str) -> tuple[str, list[tuple[int, int]]]:
    """Blank code and comments; return the text and the spans of ```math blocks."""
    text = _without_comments(text)
    spans: list[tuple[int, int]] = []
    lines: list[str] = []
    fence, language, begin = "", "", 0
    for offset, line in _lines(text):
        found = _FENCE.match(line)
        if fence:
            closed = found is not None and found.group(1).startswith(fence)
            if closed and language == "math":
                spans.append((begin, offset))
            lines.append(blanked(line) if closed or language != "math" else line)
            fence = "" if closed else fence
        elif found:
            fence, language, begin = found.group(1), found.group(2).lower(), offset + len(line)
            lines.append(blanked(line))
        else:
            without = _CODE.sub(lambda m: blanked(m.group()), line)
            lines.append(_BOLD.sub(lambda m: f"  {m.group(1)}  ", without))
    return mask_plain("".join(lines)), spans


def _lines(text: str) -> Iterator[tuple[int, str]]:
    place = 0
    while place < len(text):
        end = text.find("\n", place)
        end = len(text) if end < 0 else end + 1
        yield place, text[place:end]
        place = end


def _without_comments(text: str) -> str:
    pieces: list[str] = []
    place = 0
    while (start := text.find("<!--", place)) >= 0:
        end = text.find("-->", start)
        end = len(text) if end < 0 else end + 3
        pieces += [text[place:start], blanked(text[start:end])]
        place = end
    return "".join([*pieces, text[place:]])
