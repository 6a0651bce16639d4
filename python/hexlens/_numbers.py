"""Numbers as text, the same as web/model/decimal.ts and web/outputs/json-number.ts write them: every rounding is of the exact value.
A jacdet is a double times 2^exponent, and may lie far outside the doubles."""

import math
from decimal import Decimal
from fractions import Fraction

__all__ = ["as_double", "js_number", "json_number", "scaled", "speak_jacdet", "speak_number", "spoken_point", "whole_or_double"]

_SHOWN_DIGITS = 5
_LEAST_PLAIN_POWER, _MOST_PLAIN_POWER = -4, 8


def as_double(mantissa: float, exponent: int) -> float | None:
    """mantissa * 2^exponent where that is exactly a double."""
    try:
        value = math.ldexp(mantissa, exponent)
    except OverflowError:
        return None
    return value if mantissa == 0 or (value != 0 and Fraction(value) == _exact(mantissa, exponent)) else None


def scaled(mantissa: float, exponent: int) -> float:
    """The nearest double, an infinity or 0 where there is no room."""
    try:
        return math.ldexp(mantissa, exponent)
    except OverflowError:
        return math.copysign(math.inf, mantissa)


def json_number(mantissa: float, exponent: int) -> float | int | str:
    """A number that reads back bit for bit, or a decimal string of 17 digits where it is no double."""
    double = as_double(mantissa, exponent)
    if double is not None:
        return whole_or_double(double)
    negative, digits, power = _rounded(_exact(mantissa, exponent), 17)
    return f"{'-' if negative else ''}{digits[0]}.{digits[1:]}e{'-' if power < 0 else '+'}{abs(power)}"


def whole_or_double(value: float) -> float | int:
    """As JSON has it from JavaScript: 1, not 1.0; -0 is 0; beyond 2^53 the shortest digits that read back, and zeros."""
    return int(Decimal(repr(value))) if value.is_integer() and abs(value) < 1e21 else value


def js_number(value: float) -> str:
    """The shortest text that reads back, as JavaScript writes it: "1e-7", not "1e-07"."""
    if math.isnan(value):
        return "NaN"
    if math.isinf(value):
        return "Infinity" if value > 0 else "-Infinity"
    if value.is_integer() and abs(value) < 1e21:
        return str(whole_or_double(value))
    mantissa, _, power = repr(value).partition("e")
    if power:
        exponent = int(power)
        if -6 <= exponent < 0:
            sign, digits = ("-", mantissa[1:]) if mantissa.startswith("-") else ("", mantissa)
            return f"{sign}0.{'0' * (-exponent - 1)}{digits.replace('.', '')}"
        return f"{mantissa.removesuffix('.0')}e{'-' if exponent < 0 else '+'}{abs(exponent)}"
    return mantissa


def speak_number(value: float) -> str:
    """Five digits, "-0.02083" or "3.88e-12", without zeros at the end."""
    return _shown(value, 0)


def speak_jacdet(mantissa: float, exponent: int) -> str:
    return _shown(mantissa, exponent)


def spoken_point(point: tuple[float, float, float]) -> str:
    """Coordinates as fractions where they are exact ones."""
    return f"({', '.join(_fraction(x) or speak_number(x) for x in point)})"


def _fraction(value: float) -> str | None:
    """p/2^k with k from 1 to 6 and |p| < 1000: larger ones read worse than decimals."""
    exact = Fraction(value)
    return str(exact) if 1 < exact.denominator <= 64 and abs(exact.numerator) < 1000 else None


def _exact(mantissa: float, exponent: int) -> Fraction:
    exact = Fraction(mantissa)
    return exact * (1 << exponent) if exponent >= 0 else exact / (1 << -exponent)


def _shown(mantissa: float, exponent: int) -> str:
    exact = _exact(mantissa, exponent)
    negative, digits, power = _rounded(exact, _SHOWN_DIGITS)
    if _SHOWN_DIGITS < power + 1 <= _MOST_PLAIN_POWER + 1:
        negative, digits, power = _rounded(exact, power + 1)
    text = digits.rstrip("0")
    if not text:
        return "0"
    sign = "-" if negative else ""
    if not _LEAST_PLAIN_POWER <= power <= _MOST_PLAIN_POWER:
        return f"{sign}{text[0]}{'.' + text[1:] if len(text) > 1 else ''}e{power}"
    if power < 0:
        return f"{sign}0.{'0' * (-power - 1)}{text}"
    whole, fraction = text[: power + 1].ljust(power + 1, "0"), text[power + 1 :]
    return f"{sign}{whole}{'.' + fraction if fraction else ''}"


def _rounded(value: Fraction, count: int) -> tuple[bool, str, int]:
    """Sign, digits (none for zero) and the power of ten of the first; half to even."""
    if value == 0:
        return False, "", 0
    size = abs(value)
    # log10(2) to the digits that a guess needs; the loops correct it.
    power = math.floor((size.numerator.bit_length() - size.denominator.bit_length()) * 0.30103)
    while size < _ten(power):
        power -= 1
    while size >= _ten(power + 1):
        power += 1
    text = str(round(size * _ten(count - 1 - power)))
    return value < 0, text[:count], power + (len(text) > count)


def _ten(power: int) -> Fraction:
    return Fraction(10**power) if power >= 0 else Fraction(1, 10**-power)
