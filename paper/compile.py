"""Compiles paper.md by pandoc to a page, and checks what a journal would: citations, figures, length, and where the numbers are from.

Needs pypandoc_binary, which has pandoc in it. `make paper` runs this.
"""

import html
import re
import sys
from pathlib import Path

import pypandoc

HERE = Path(__file__).parent
ROOT = HERE.parent
SECTIONS = ["Summary", "Statement of need", "State of the field", "Software design", "Research impact"]
SHORTEST, LONGEST = 750, 1250


def sources(text: str) -> list[str]:
    """Statements whose numbers are not in the file that they name."""
    notes = re.findall(r'<!-- (\S+): "([^"]*)" -->', text)
    wrong = [note for note in notes if note[1] not in (ROOT / note[0]).read_text(encoding="utf-8")]
    found = [f'{file} does not have "{words}"' for file, words in wrong]
    return found if notes else ["no statement names its source"]


def length(text: str) -> int:
    """Words of the text, as the journal counts them: without head, comments, addresses and references."""
    body = text.split("\n---\n", 1)[1].split("\n# References")[0]
    body = re.sub(r"<!--.*?-->", " ", body, flags=re.S)
    body = re.sub(r"\]\([^)]*\)|\[@[^]]*\]|\\\w+\{[^}]*\}", " ", body)
    return len(re.findall(r"\w[\w.,’'–-]*", body))


def compiled(out: Path) -> tuple[str, list[str]]:
    """The page, and what pandoc says about it."""
    arguments = ["--citeproc", "--standalone", "--embed-resources", "--mathml", "--fail-if-warnings", f"--resource-path={HERE}"]
    try:
        pypandoc.convert_file(str(HERE / "paper.md"), "html5", outputfile=str(out), extra_args=arguments, cworkdir=str(HERE))
    except RuntimeError as error:
        return "", [str(error)]
    return html.unescape(out.read_text(encoding="utf-8")), []


def faults(out: Path) -> list[str]:
    text = (HERE / "paper.md").read_text(encoding="utf-8")
    found = sources(text)
    words = length(text)
    print(f"{words} words")
    if not SHORTEST <= words <= LONGEST:
        found.append(f"{words} words; {SHORTEST} to {LONGEST} are allowed")
    found += [f"no section {name}" for name in SECTIONS if f"\n# {name}\n" not in text]
    figures = re.findall(r"!\[.*?\]\(([^)]*)\)", text)
    found += [f"no figure {name}" for name in figures if not (HERE / name).is_file()]
    found += [] if figures else ["no figures"]
    page, said = compiled(out)
    found += said
    cited = set(re.findall(r"@(\w+)", re.sub(r"<!--.*?-->", "", text.split("\n---\n", 1)[1])))
    entries = set(re.findall(r"^@\w+\{(\w+),", (HERE / "paper.bib").read_text(encoding="utf-8"), flags=re.M))
    found += [f"{name} is not in paper.bib" for name in cited - entries]
    found += [f"{name} of paper.bib is not cited" for name in entries - cited]
    found += [f"{name} is not in the list of references" for name in cited if page and f'id="ref-{name}"' not in page]
    found += [f"{count} pictures in the page, {len(figures)} in the text" for count in [page.count("<img")] if page and count != len(figures)]
    return found


if __name__ == "__main__":
    out = Path(sys.argv[1]).resolve()
    out.parent.mkdir(parents=True, exist_ok=True)
    found = faults(out)
    print("\n".join(found) or f"{out} is complete")
    sys.exit(bool(found))
