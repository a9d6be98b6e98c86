"""The bit model of the paced line. Each expectation is worked out by hand from the characters' levels."""
import unittest

from uart import BREAK, Frame, heard, sent

N81, E81, O81, E71, N82 = Frame(8, "N", 1), Frame(8, "E", 1), Frame(8, "O", 1), Frame(7, "E", 1), Frame(8, "N", 2)
IDLE = "1" * 12


def read(data, sender, receiver):
    return heard("", "".join(sent(byte, sender) for byte in data) + IDLE, receiver)[1]


class ACharacter(unittest.TestCase):
    def test_has_its_lowest_bit_first_between_start_and_stop(self):
        self.assertEqual(sent(0x41, N81), "0" "10000010" "1")

    def test_has_a_parity_bit_which_makes_the_ones_even_or_odd(self):
        self.assertEqual(sent(0x41, E81), "0" "10000010" "0" "1")
        self.assertEqual(sent(0x43, E81), "0" "11000010" "1" "1")
        self.assertEqual(sent(0x43, O81), "0" "11000010" "0" "1")

    def test_loses_its_eighth_bit_where_seven_are_sent(self):
        self.assertEqual(sent(0xC3, E71), "0" "1100001" "1" "1")

    def test_ends_with_two_stop_bits_where_two_are_set(self):
        self.assertEqual(sent(0x00, N82), "0" "00000000" "11")


class AReceiver(unittest.TestCase):
    def test_reads_every_byte_of_its_own_settings(self):
        every = bytes(range(256))
        for frame in (N81, E81, O81, N82):
            self.assertEqual(read(every, frame, frame), every)
        self.assertEqual(read(every[:128], E71, E71), every[:128])

    def test_finds_the_parity_of_seven_bits_in_the_eighth(self):
        # A has two ones, C has three: its parity bit is set.
        self.assertEqual(read(b"AC", E71, N81), b"\x41\xc3")

    def test_cannot_tell_one_stop_bit_from_two(self):
        self.assertEqual(read(b"AC\x00\xff", N82, N81), b"AC\x00\xff")
        self.assertEqual(read(b"AC\x00\xff", N81, N82), b"AC\x00\xff")

    def test_passes_over_bytes_of_the_other_parity(self):
        self.assertEqual(read(b"AC\x00\xff", O81, E81), b"")

    def test_without_parity_takes_a_parity_bit_that_is_set_for_the_stop_bit(self):
        self.assertEqual(read(b"CL", E81, N81), b"CL")

    def test_without_parity_takes_a_parity_bit_that_is_not_set_for_the_next_start_bit(self):
        # 0 10000010 0 1, idle: A with a framing error, as sampled; then from the parity bit on 0 11111111 1.
        self.assertEqual(read(b"A", E81, N81), b"A\xff")

    def test_with_parity_takes_the_stop_bit_for_it(self):
        # C has three ones and so the right parity, A has two; after each the line is idle.
        self.assertEqual(read(b"C", N81, E81), b"C")
        self.assertEqual(read(b"A", N81, E81), b"")

    def test_with_parity_misses_the_stop_bit_where_the_next_character_follows_at_once(self):
        # 0 11000010 1 | 0 10000010 1: C lacks its stop bit and is passed over. The start bit that stood there counts for A, whose
        # stop bit is no even parity.
        self.assertEqual(read(b"CA", N81, E81), b"")

    def test_reads_a_zero_where_the_line_is_low_for_a_whole_character_and_waits_for_the_mark(self):
        # 0 00000000 0 1: ten levels of space are a character of 8N1 without its stop bit.
        self.assertEqual(read(b"\x00C", E81, N81), b"\x00C")
        self.assertEqual(heard("", "0" * 40, N81), (BREAK, b"\x00"))

    def test_keeps_a_character_that_comes_in_two_parts(self):
        pending, nothing = heard("", "0100", N81)
        self.assertEqual((pending, nothing), ("0100", b""))
        self.assertEqual(heard(pending, "000101", N81), ("", b"A"))


if __name__ == "__main__":
    unittest.main()
