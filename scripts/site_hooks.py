# SPDX-License-Identifier: GPL-3.0-or-later
"""What MkDocs does otherwise for the site: an asterisk behind a word, as in `stress p* of`, begins no emphasis; links name files; formulas
are set as formulas."""

import re
import sys
from pathlib import Path

from markdown.extensions import Extension
from markdown.inlinepatterns import AsteriskProcessor

sys.path.insert(0, str(Path(__file__).parent))

from reference_pages import WRITTEN as REFERENCE  # noqa: E402
from site_formulas import FormulaExtension  # noqa: E402

# Pages that a program of the project writes.
WRITTEN = ("docs/gallery.md", "docs/guide/tutorial.md", *REFERENCE)


# From the heading of the proofs to the next one of its kind.
PROOFS = re.compile(r'<h2 id="proofs">.*?(?=<h2 |\Z)', re.DOTALL)


class EmphasisProcessor(AsteriskProcessor):
    """Emphasis that begins neither behind a word or a bracket nor before a space."""

    PATTERNS = [item._replace(pattern=re.compile(r"(?<![\w)\]])(?=\*+\S)" + item.pattern.pattern, item.pattern.flags))
                for item in AsteriskProcessor.PATTERNS]


class EmphasisExtension(Extension):
    """Puts this emphasis in the place of the usual one."""

    def extendMarkdown(self, md):
        md.inlinePatterns.register(EmphasisProcessor(r"\*"), "em_strong", 60)


def on_config(config):
    """Called by MkDocs before it reads the documents."""
    config.markdown_extensions.extend([EmphasisExtension(), FormulaExtension()])
    return config


def on_page_content(html, page, files, **_):
    """Called by MkDocs for the words of each page: proofs stand in a box, and at the end the notebook of the page, if it has one."""
    html = PROOFS.sub(r'<section class="proofs">\n\g<0></section>\n', html)
    file = files.get_file_from_path(page.file.src_uri.removesuffix(".md") + ".ipynb")
    if file is None:
        return html
    return f'{html}\n<p class="notebook"><a href="{Path(file.src_uri).name}" download>This page as a notebook</a></p>'


def on_page_context(context, page, **_):
    """Called by MkDocs for each page before it is written: what a program writes has no link to where it is edited."""
    if page.file.src_uri in WRITTEN:
        page.edit_url = None
    return context


def on_post_page(output, **_):
    """Called by MkDocs for each page: where a link leads to a folder it names the first page there, which needs no server then."""
    return re.sub(r'href="(\./|(?:\.\./)*)\.(\.?)"', lambda link: f'href="{link[1]}{"../" if link[2] else ""}index.html"', output)


def on_post_template(output_content, **_):
    """Called by MkDocs for pages that belong to no document."""
    return on_post_page(output_content)
