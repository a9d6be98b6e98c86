"""Characters of an asynchronous serial line as levels, "1" the mark and "0" the space, and what a receiver with settings of its own
makes of them: a 16550A as its data sheet (TI PC16550D, line status register) tells, behind Linux's 8250_port.c."""
import functools
import typing

BREAK = "break"  # the receiver waits for the mark, since the line stayed at the space for a whole character


class Frame(typing.NamedTuple):
    data_bits: int
    parity: str  # N, E, O
    stop_bits: int


def parity_bit(data, parity):
    """With it, the number of ones is even or odd."""
    return str((data.count("1") + (parity == "O")) % 2)


def sent(byte, frame):
    """Levels of one character: start, data from the lowest bit, parity, stop."""
    data = format(byte & (1 << frame.data_bits) - 1, f"0{frame.data_bits}b")[::-1]
    return "0" + data + (parity_bit(data, frame.parity) if frame.parity != "N" else "") + "1" * frame.stop_bits


def character(levels, frame):
    """What a program reads of one character. Drydock sets INPCK and IGNPAR where there is parity, and neither where there is none.
    So with parity the kernel passes over a byte in error, and without it hands the byte over as it was sampled."""
    data, checked = levels[1:1 + frame.data_bits], frame.parity != "N"
    wrong = levels[-1] == "0" or (checked and levels[-2] != parity_bit(data, frame.parity))
    is_break = "1" not in levels
    return b"" if wrong and checked and not is_break else bytes([int(data[::-1], 2)])


@functools.lru_cache(maxsize=1 << 16)
def heard(pending, line, frame):
    """The levels of an incomplete character and those that follow -> the incomplete rest, and the bytes that a program reads.
    A receiver looks at the first stop bit alone. If that is missing, it takes it for the next start bit."""
    length, data = 1 + frame.data_bits + (frame.parity != "N") + 1, b""
    for level in line:
        if pending == BREAK or not pending:
            pending = (BREAK if pending else "0") if level == "0" else ""
            continue
        pending += level
        if len(pending) >= length:  # longer, if the receiver was set to fewer bits in the middle of it
            data += character(pending, frame)
            pending = BREAK if "1" not in pending else "0" if level == "0" else ""
    return pending, data
