"""Writes the font of the lessons' formulas: the part of STIX Two Math that they need.

    npm pack @fontsource/stix-two-math@5.3.0 && tar xf fontsource-stix-two-math-5.3.0.tgz
    pip install fonttools==4.68.0 brotli==1.2.1
    python3 tools/math-font.py package/files/stix-two-math-latin-400-normal.woff2

The licence of the font, SIL OFL 1.1, lies beside it. No name in it is reserved.
"""

import hashlib
import sys
from pathlib import Path

from fontTools import subset

SOURCE_SHA256 = "8b2a6834cfe1f4e0f3724ffa59fe92000013fc5a4c41e6a3f438006c26c60f0d"
FOLDER = Path(__file__).parent.parent / "web" / "pages" / "lessons" / "math-font"
LARGEST = 40_000

LATIN = [chr(c) for first in "Aa" for c in range(ord(first), ord(first) + 26)]
# U+1D455 is not a character: the italic h is Planck's constant.
LATIN_ITALIC = [chr(c) for c in range(0x1D434, 0x1D468) if c != 0x1D455] + ["\u210e"]
GREEK = [chr(c) for c in range(0x3B1, 0x3CA)] + list("ΔΛΞΣΦΨΩ")
# Small letters, and the partial derivative after them.
GREEK_ITALIC = [chr(c) for c in range(0x1D6FC, 0x1D716)] + ["\U0001d6e5", "\U0001d6ef"]
SIGNS = list(" \u00a00123456789.,:;!?()[]{}|/+-−±×·*=≠<>≤≥≈→↦∈∞∂∇√∑∫′″‴…¬∧∨") + ["\u2061", "\u2062", "\u2217", "ℓ", "\u20d7"]


def main(source: str) -> None:
    data = Path(source).read_bytes()
    found = hashlib.sha256(data).hexdigest()
    if found != SOURCE_SHA256:
        sys.exit(f"{source} is not the file that the font was made from: its SHA-256 is {found}.")
    characters = sorted(set(LATIN + LATIN_ITALIC + GREEK + GREEK_ITALIC + SIGNS))
    options = subset.Options(
        flavor="woff2",
        hinting=False,
        layout_features=["kern"],
        name_IDs=[0, 1, 2, 3, 4, 5, 6, 13, 14],
        notdef_outline=True,
    )
    font = subset.load_font(source, options)
    missing = [c for c in characters if ord(c) not in font.getBestCmap()]
    if missing:
        sys.exit(f"The font does not have {missing}.")
    subsetter = subset.Subsetter(options)
    subsetter.populate(text="".join(characters))
    subsetter.subset(font)
    target = FOLDER / "stix-two-math.woff2"
    subset.save_font(font, target, options)
    (FOLDER / "characters.txt").write_text("".join(characters) + "\n", encoding="utf-8")
    size = target.stat().st_size
    print(f"{target}: {size} bytes, {len(characters)} characters")
    if size > LARGEST:
        sys.exit(f"That is more than {LARGEST} bytes.")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
