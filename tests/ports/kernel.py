#!/usr/bin/env python3
"""Debian's own kernel, made ready for a machine in software: kernel.py FOLDER

Downloads the package that linux-image-amd64 depends on (70 MB; it is not installed; DRYDOCK_PORTS_PACKAGE names another,
linux-image-rt-amd64 has PREEMPT_RT), and keeps three things of it: `vmlinux`,
unpacked here since the software processor would take 5 s for it; the modules of CAN, USB serial ports and of the machine
itself; an `initramfs.cpio` that loads them and mounts this machine's files (guest-init). Does nothing if they are there."""
import hashlib
import lzma
import os
import pathlib
import re
import shutil
import subprocess
import sys

PACKAGE = os.environ.get("DRYDOCK_PORTS_PACKAGE", "linux-image-amd64")
# Loaded at boot, in this order; each brings what it depends on.
AT_BOOT = ["virtio_pci", "9pnet_virtio", "9p", "overlay", "virtio_console", "xhci-pci", "ftdi_sio", "can-raw", "kvaser_pci",
           "vhci-hcd", "gs_usb", "usb_8dev"]
FOLDERS = ["arch/x86/crypto", "crypto", "drivers/char", "drivers/net/can", "drivers/tty", "drivers/usb", "drivers/virtio", "fs/9p",
           "fs/fscache", "fs/netfs", "fs/overlayfs", "lib", "net/9p", "net/can"]
HERE = pathlib.Path(__file__).resolve().parent


class NoKernel(Exception):
    """Why there is no kernel to boot, in one line."""


def run(*words, **options):
    return subprocess.run([str(w) for w in words], check=True, capture_output=True, **options).stdout


def download(folder):
    """The package file of the newest kernel. `apt-get update` runs only if apt knows no such package."""
    for refresh in (False, True):
        if refresh:
            run("apt-get", "update", "-qq")
        found = re.search(r"Depends: (linux-image-\S+)", run("apt-cache", "depends", PACKAGE, text=True))
        try:
            if found:
                run("apt-get", "-o", "APT::Sandbox::User=root", "download", found[1], cwd=folder)
                return next(folder.glob("*.deb"))
        except subprocess.CalledProcessError as error:
            if refresh:
                raise NoKernel(f"cannot download {found[1]}: {error.stderr.decode().strip().splitlines()[-1]}") from None
    raise NoKernel(f"apt knows no package {PACKAGE}")


def unpacked(image):
    """The kernel inside a bzImage; the boot header says where (Documentation/x86/boot.rst: 0x1f1, 0x248, 0x24c)."""
    number = lambda at, size: int.from_bytes(image[at:at + size], "little")
    start = (number(0x1F1, 1) + 1) * 512 + number(0x248, 4)
    return lzma.LZMADecompressor().decompress(image[start:start + number(0x24C, 4)])


def initramfs(root, version, folder):
    """busybox, the modules in the order in which they are loaded, and guest-init."""
    tree = folder / "initramfs"
    (tree / "modules").mkdir(parents=True)
    (tree / "bin").mkdir()
    shutil.copy(shutil.which("busybox"), tree / "bin/busybox")
    shutil.copy(HERE / "guest-init", tree / "init")
    (tree / "init").chmod(0o755)
    order = {}
    for name in AT_BOOT:
        for line in run("modprobe", "-d", root, "-S", version, "--show-depends", name, text=True).splitlines():
            if line.startswith("insmod "):
                order[line.split()[1]] = None
    for path in order:
        shutil.copy(path, tree / "modules")
    (tree / "order").write_text("".join(pathlib.Path(p).name + "\n" for p in order))
    names = "\n".join(str(p.relative_to(tree)) for p in sorted(tree.rglob("*")))
    (folder / "initramfs.cpio").write_bytes(run("cpio", "-o", "-H", "newc", "--quiet", cwd=tree, input=names.encode()))
    shutil.rmtree(tree)


def prepare(folder):
    key = PACKAGE + " " + hashlib.sha256(pathlib.Path(__file__).read_bytes() + (HERE / "guest-init").read_bytes()).hexdigest()
    if (folder / "key").exists() and (folder / "key").read_text() == key:
        return
    shutil.rmtree(folder, ignore_errors=True)
    root = folder / "root"
    root.mkdir(parents=True)
    package = download(folder)
    version = re.sub(r"linux-image-([^_]+)_.*", r"\1", package.name)
    modules = f"./lib/modules/{version}"
    wanted = [f"./boot/vmlinuz-{version}"] + [f"{modules}/kernel/{f}" for f in FOLDERS]
    wanted += [f"{modules}/modules.{f}" for f in ("order", "builtin", "builtin.modinfo")]
    archive = subprocess.Popen(["dpkg-deb", "--fsys-tarfile", package], stdout=subprocess.PIPE)
    # A folder that this kernel has not is no fault: what is needed at boot is asked for below.
    subprocess.run(["tar", "x", "-C", root, *wanted], stdin=archive.stdout, stderr=subprocess.DEVNULL)
    archive.stdout.read()
    archive.wait()
    package.unlink()
    run("depmod", "-b", root, version)
    (folder / "vmlinux").write_bytes(unpacked((root / f"boot/vmlinuz-{version}").read_bytes()))
    initramfs(root, version, folder)
    (folder / "version").write_text(version)
    (folder / "key").write_text(key)


if __name__ == "__main__":
    try:
        prepare(pathlib.Path(sys.argv[1]).resolve())
    except NoKernel as why:
        sys.exit(f"ports: {why}")
