#!/usr/bin/env python3
"""Runs commands in a machine in software (QEMU, no KVM) on Debian's own kernel and this machine's files, which has
  ttyS1 ttyS2      two 16550A, joined by a null modem         ttyUSB0 ttyUSB1  two FTDI adapters (ftdi_sio), joined likewise
  ttyS4 ttyS5      the same on PCI, on a paced line           ttyUSB2 ttyUSB3  the same, on a paced line
  can0 can1        two SJA1000 controllers (kvaser_pci) on one bus, down
  /dev/qmp         the machine's own control: unplug and plug the adapters usb0 and usb1 (QMP device_del, device_add)
usage: with-ports.py [--virtual] [--seconds N] COMMAND [ARGUMENT...] [--and COMMAND...] [--then COMMAND...]
--and: this command runs beside the one before; --then: it runs when all before have ended. Exit status: the first that is not 0.
GoogleTest programs tell which of the kernel's drivers each test used (driver.hpp): the last lines are a table of those.
A paced line carries bytes at the rates, with the parity and bits that its ports are set to (null_modem.py; the library of
line_settings.c is named in DRYDOCK_LINE_SETTINGS_LIBRARY).
--virtual: the machine's time counts instructions, 2 ns each, and passes over idle time. It has no serial ports then.
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

import driver_table
import kernel
from null_modem import NullModem

TREE = pathlib.Path(__file__).resolve().parents[2]
KERNEL = pathlib.Path(os.environ.get("DRYDOCK_PORTS_KERNEL", TREE / "build/ports"))
PLAIN, PACED = ["uart0", "uart1", "usb0", "usb1"], ["uart2", "uart3", "usb2", "usb3"]


def absent():
    """Why the machine cannot be made here, or None."""
    for tool in ("qemu-system-x86_64", "busybox", "modprobe", "depmod", "cpio", "dpkg-deb"):
        if not shutil.which(tool):
            return f"{tool} is missing (its package stands in .ci/packages-peers.txt)"
    if os.uname().machine != "x86_64":
        return "the machine in software is an x86-64"
    try:
        kernel.prepare(KERNEL)
    except kernel.NoKernel as why:
        return str(why)
    return None


def stages(words):
    """The words of each command: a list of those that run one after the other, of lists of those that run at once."""
    found = [[[]]]
    for word in words:
        if word == "--then":
            found.append([[]])
        elif word == "--and":
            found[-1].append([])
        else:
            found[-1][-1].append(word)
    return found


def write_command(share, words, virtual):
    """What the guest runs: the commands with this process's environment, their output into files of the share."""
    version = (KERNEL / "version").read_text()
    exports = "".join(f"export {k}={shlex.quote(v)}\n" for k, v in os.environ.items() if k.isidentifier())
    lines, number = [], 0
    for stage in stages(words):
        for command in stage:
            lines.append(f"(GTEST_OUTPUT=json:/run/ports/{number}.tests.json {shlex.join(command)} </dev/null >/run/out/{number}.out "
                         f"2>/run/out/{number}.err; echo $? >/run/out/{number}.status; /run/busybox cp /run/out/{number}.* /run/ports) &")
            number += 1
        lines.append("wait")
    ready = "" if virtual else "for i in 1 2 3 4 5 6 7 8 9; do [ -e /dev/ttyUSB3 ] || /run/busybox sleep 0.2; done"
    (share / "command").write_text(f"""{exports}
export PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
mkdir -p /run/out /lib/modules && ln -sfn {KERNEL}/root/lib/modules/{version} /lib/modules/{version}
{ready}
cd {shlex.quote(os.getcwd())}
{chr(10).join(lines)}
for status in /run/out/*.status; do read -r code <$status; [ $code = 0 ] || break; done
echo $code >/run/ports/status.new
/run/busybox mv /run/ports/status.new /run/ports/status
/run/busybox reboot -f
""")


def serial_ports(modems):
    """QEMU's words for the ports and the ends of their lines."""
    words = []
    for modem, names in zip(modems, (PLAIN[:2], PLAIN[2:], PACED[:2], PACED[2:])):
        for name, end in zip(names, modem.ends):
            kind, _, rest = end.chardev.partition(",")
            words += ["-chardev", f"{kind},id={name},{rest}"]
    words += ["-device", "isa-serial,index=1,chardev=uart0", "-device", "isa-serial,index=2,chardev=uart1",
              "-device", "pci-serial-2x,chardev1=uart2,chardev2=uart3", "-device", "qemu-xhci"]
    for port, (name, serial) in enumerate(zip(("usb0", "usb1", "usb2", "usb3"), "ABCD"), 1):
        words += ["-device", f"usb-serial,id={name},port={port},serial={serial},chardev={name}"]
    return words


def machine(share, modems, virtual):
    """The words of QEMU's command line."""
    pace = ["-accel", "tcg,thread=single", "-icount", "shift=1,sleep=off"] if virtual else ["-accel", "tcg,thread=multi"]
    nine = "security_model=none,multidevs=remap"
    # What takes a software processor long and no test asks for: self-tests, and write protection of the kernel itself.
    quick = "rodata=off random.trust_cpu=on cryptomgr.notests no_timer_check mitigations=off tsc=reliable"
    return ["qemu-system-x86_64", *pace, "-M", "q35", "-cpu", "max", "-smp", "1", "-m", "1G", "-nodefaults",
            "-display", "none", "-no-reboot", "-serial", f"file:{share}/console", "-kernel", KERNEL / "vmlinux",
            "-initrd", KERNEL / "initramfs.cpio",
            "-append", f"console=ttyS0 quiet panic=-1 {quick} reboot=t net.ifnames=0 8250.nr_uarts=6",
            "-fsdev", f"local,id=files,path=/,readonly=on,{nine}", "-device", "virtio-9p-pci,fsdev=files,mount_tag=files",
            "-fsdev", f"local,id=share,path={share},{nine}", "-device", "virtio-9p-pci,fsdev=share,mount_tag=share",
            "-device", "virtio-serial-pci", "-object", "can-bus,id=bus",
            "-chardev", f"socket,id=control,path={share}/qmp,server=on,wait=off",
            "-chardev", f"socket,id=control2,path={share}/qmp", "-mon", "chardev=control,mode=control",
            "-device", "virtserialport,nr=3,chardev=control2,name=qmp",
            *([] if virtual else serial_ports(modems)),
            "-device", "kvaser_pci,canbus=bus", "-device", "kvaser_pci,canbus=bus"]


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


def settings_told(share):
    """What makes QEMU write down the parity and the bits of the ports (line_settings.c); else they are 8N1."""
    library = os.environ.get("DRYDOCK_LINE_SETTINGS_LIBRARY")
    return {"LD_PRELOAD": library, "DRYDOCK_LINE_SETTINGS": str(share)} if library else {}


def first_in_line():
    """A machine in software keeps real time beside busy neighbours only if it goes before them; a user who may not say so waits."""
    try:
        os.setpriority(os.PRIO_PROCESS, 0, -15)
    except PermissionError:
        pass


def lines_of(share):
    """The null modems, at work."""
    modems = [NullModem(paced, [f"{share}/{name}" for name in names])
              for paced, names in ((False, PLAIN[:2]), (False, PLAIN[2:]), (True, PACED[:2]), (True, PACED[2:]))]
    for modem in modems:
        modem.start()
    return modems


def tell(share):
    """What each command printed, then the table of kernel drivers."""
    for name, stream in (("out", sys.stdout), ("err", sys.stderr)):
        for path in sorted(share.glob(f"*.{name}")):
            stream.write(path.read_text(errors="replace"))
            stream.flush()
    print(driver_table.table(sorted(share.glob("*.tests.json"))), end="")


def run(options):
    first_in_line()
    with tempfile.TemporaryDirectory(prefix="drydock-ports-") as folder:
        share = pathlib.Path(folder)
        modems = [] if options.virtual else lines_of(share)
        write_command(share, options.command, options.virtual)
        guest = subprocess.Popen(machine(share, modems, options.virtual), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                 env=os.environ | settings_told(share))
        try:
            if not ended(guest, share, options.seconds):
                print(f"ports: the machine did not end within {options.seconds:g} s", file=sys.stderr)
        finally:
            guest.kill()
            guest.wait()
        tell(share)
        if status_of(share):
            return int(status_of(share))
        print("ports: the machine ended without an exit status; its console:", file=sys.stderr)
        print((share / "console").read_text(errors="replace")[-2000:], file=sys.stderr)
        return 1


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
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
