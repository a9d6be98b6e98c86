#!/usr/bin/env python3
"""Runs a command in a machine in software (QEMU, no KVM) on Debian's own kernel and this machine's files, which has
  ttyS1 ttyS2      two 16550A, joined by a null modem         ttyUSB0 ttyUSB1  two FTDI adapters (ftdi_sio), joined likewise
  can0 can1        two SJA1000 controllers (kvaser_pci) on one bus, down
  /dev/qmp         the machine's own control: unplug and plug the adapters usb0 and usb1 (QMP device_del, device_add)
usage: with-ports.py [--paced] [--virtual] [--seconds N] COMMAND [ARGUMENT...]      exit status of the command
--paced: the lines carry bytes at the rates, with the parity and bits that the ports are set to (null_modem.py; the library
of line_settings.c is named in DRYDOCK_LINE_SETTINGS_LIBRARY).
--virtual: the machine's time counts instructions, 2 ns each, and passes over idle time. Not for serial ports.
Where it cannot run, one line says why; the exit status is 77 (skipped), or 1 if CI=true."""
import argparse
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

import kernel
from null_modem import NullModem

TREE = pathlib.Path(__file__).resolve().parents[2]
KERNEL = pathlib.Path(os.environ.get("DRYDOCK_PORTS_KERNEL", TREE / "build/ports"))
PORTS = ["uart0", "uart1", "usb0", "usb1"]


def absent():
    """Why the machine cannot be made here, or None."""
    for tool in ("qemu-system-x86_64", "busybox", "modprobe", "depmod", "cpio", "dpkg-deb"):
        if not shutil.which(tool):
            return f"{tool} is missing (its package stands in .ci/packages-tests.txt)"
    if os.uname().machine != "x86_64":
        return "the machine in software is an x86-64"
    try:
        kernel.prepare(KERNEL)
    except kernel.NoKernel as why:
        return str(why)
    return None


def write_command(share, arguments):
    """What the guest runs: the command with this process's environment, its output into the two ports."""
    version = (KERNEL / "version").read_text()
    exports = "".join(f"export {k}={shlex.quote(v)}\n" for k, v in os.environ.items() if k.isidentifier())
    (share / "command").write_text(f"""{exports}
export PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
mkdir -p /lib/modules && ln -sfn {KERNEL}/root/lib/modules/{version} /lib/modules/{version}
for i in 1 2 3 4 5 6 7 8 9; do [ -e /dev/ttyUSB1 ] || /run/busybox sleep 0.2; done
cd {shlex.quote(os.getcwd())}
{shlex.join(arguments)} </dev/null >/dev/ports.out 2>/dev/ports.err
echo $? >/run/ports/status
/run/busybox reboot -f
""")


def machine(share, modem, virtual):
    """The words of QEMU's command line."""
    pace = ["-accel", "tcg,thread=single", "-icount", "shift=1,sleep=off"] if virtual else ["-accel", "tcg,thread=multi"]
    nine = "security_model=none,multidevs=remap"
    words = ["qemu-system-x86_64", *pace, "-M", "q35", "-cpu", "max", "-smp", "1", "-m", "1G", "-nodefaults",
             "-display", "none", "-no-reboot", "-serial", f"file:{share}/console", "-kernel", KERNEL / "vmlinux",
             "-initrd", KERNEL / "initramfs.cpio",
             "-append", "console=ttyS0 quiet panic=-1 mitigations=off tsc=reliable reboot=t net.ifnames=0",
             "-fsdev", f"local,id=files,path=/,readonly=on,{nine}", "-device", "virtio-9p-pci,fsdev=files,mount_tag=files",
             "-fsdev", f"local,id=share,path={share},{nine}", "-device", "virtio-9p-pci,fsdev=share,mount_tag=share",
             "-device", "virtio-serial-pci", "-object", "can-bus,id=bus",
             "-chardev", f"socket,id=control,path={share}/qmp,server=on,wait=off",
             "-chardev", f"socket,id=control2,path={share}/qmp", "-mon", "chardev=control,mode=control",
             "-device", "virtserialport,nr=3,chardev=control2,name=qmp"]
    for number, name in enumerate(("out", "err"), 1):
        words += ["-chardev", f"file,id={name},path={share}/{name}",
                  "-device", f"virtserialport,nr={number},chardev={name},name=ports.{name}"]
    for name, end in zip(PORTS, modem.ends):
        kind, _, rest = end.chardev.partition(",")
        words += ["-chardev", f"{kind},id={name},{rest}"]
    words += ["-device", "isa-serial,index=1,chardev=uart0", "-device", "isa-serial,index=2,chardev=uart1", "-device", "qemu-xhci"]
    for port, (name, serial) in enumerate((("usb0", "A"), ("usb1", "B")), 1):
        words += ["-device", f"usb-serial,id={name},port={port},serial={serial},chardev={name}"]
    return words + ["-device", "kvaser_pci,canbus=bus", "-device", "kvaser_pci,canbus=bus"]


def status_of(share):
    """The command's exit status as text; empty while it runs."""
    status = share / "status"
    return status.read_text().strip() if status.exists() else ""


def ended(guest, share, seconds):
    """Waits for the command's end, not for the machine's: a kernel that lost a USB controller may never halt."""
    end = time.monotonic() + seconds
    while guest.poll() is None and not status_of(share):
        if time.monotonic() > end:
            return False
        time.sleep(0.05)
    return True


def settings_told(share, paced):
    """What makes QEMU write down the parity and the bits of the ports (line_settings.c)."""
    return {"LD_PRELOAD": os.environ["DRYDOCK_LINE_SETTINGS_LIBRARY"], "DRYDOCK_LINE_SETTINGS": str(share)} if paced else {}


def run(options):
    with tempfile.TemporaryDirectory(prefix="drydock-ports-") as folder:
        share = pathlib.Path(folder)
        modem = NullModem(options.paced, [f"{share}/{name}" for name in PORTS])
        modem.start()
        write_command(share, options.command)
        guest = subprocess.Popen(machine(share, modem, options.virtual), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                 env=os.environ | settings_told(share, options.paced))
        try:
            if not ended(guest, share, options.seconds):
                print(f"ports: the machine did not end within {options.seconds:g} s", file=sys.stderr)
        finally:
            guest.kill()
            guest.wait()
        for name, stream in (("out", sys.stdout), ("err", sys.stderr)):
            stream.write((share / name).read_text(errors="replace"))
        if status_of(share):
            return int(status_of(share))
        print("ports: the machine ended without an exit status; its console:", file=sys.stderr)
        print((share / "console").read_text(errors="replace")[-2000:], file=sys.stderr)
        return 1


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--paced", action="store_true")
    arguments.add_argument("--virtual", action="store_true")
    arguments.add_argument("--seconds", type=float, default=300)
    arguments.add_argument("command", nargs=argparse.REMAINDER)
    options = arguments.parse_args()
    reason = absent()
    if reason:
        print(f"ports: not run, {reason}", file=sys.stderr)
        return 1 if os.environ.get("CI") == "true" else 77
    return run(options)


sys.exit(main())
