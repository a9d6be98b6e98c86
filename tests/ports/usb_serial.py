#!/usr/bin/env python3
"""A USB serial adapter in software, an FTDI FT232H, for the kernel's own ftdi_sio: usb_serial.py

QEMU's adapter takes a latency timer and does not wait for it. This one keeps bytes as the chip does: until a packet is full, or
until its timer runs out, which starts with each packet (FTDI AN232B-04). The chip's packets without bytes are left out.
Its order beside those of usb_device.py: say COUNT. Its UART then reads so many lines, one every 30 to 46 ms, each with the time at
which it was there, in nanoseconds of CLOCK_MONOTONIC, and the latency timer that the chip was told, in milliseconds."""
import math
import struct
import threading
import time

import usb_device

# linux/drivers/usb/serial/ftdi_sio.h
GET_MODEM_STATUS, SET_LATENCY_TIMER, GET_LATENCY_TIMER, READ_EEPROM = 5, 9, 10, 0x90
STATUS = b"\x31\x60"  # CTS and DSR; the transmitter is empty
FULL = 512 - len(STATUS)


class Ft232h(usb_device.Device):
    vendor, model, release, pipes, product = 0x0403, 0x6014, 0x900, (0x81, 0x02), "Serial adapter"

    def __init__(self):
        super().__init__()
        self.timer_ms, self.held, self.packet_at, self.heard = 16, b"", time.monotonic(), threading.Event()
        threading.Thread(target=self.give_packets, daemon=True).start()

    def control_of(self, request, value, data):
        if request == SET_LATENCY_TIMER:
            self.timer_ms = value
        answers = {GET_MODEM_STATUS: STATUS, GET_LATENCY_TIMER: struct.pack("B", self.timer_ms), READ_EEPROM: b"\xff\xff"}
        return answers.get(request, b"")

    def sent(self, _, data):
        """Nothing hangs at its transmitter."""

    def hear(self, data):
        with self.lock:
            self.held += data
        self.heard.set()

    def until_timer_s(self):
        period_s, passed_s = self.timer_ms / 1e3, time.monotonic() - self.packet_at
        return math.ceil(passed_s / period_s) * period_s - passed_s

    def give_packets(self):
        while self.heard.wait():
            self.heard.clear()
            while self.held:
                if len(self.held) < FULL:
                    time.sleep(self.until_timer_s())
                with self.lock:
                    packet, self.held = self.held[:FULL], self.held[FULL:]
                    self.packet_at = time.monotonic()
                    self.give_now(1, STATUS + packet)

    def obey(self, order, *words):
        if order != "say":
            return super().obey(order, *words)
        for number in range(int(words[0])):
            time.sleep(0.030 + number * 0.0071 % 0.016)
            self.hear(b"%d %d\n" % (time.monotonic_ns(), self.timer_ms))


usb_device.main(Ft232h())
