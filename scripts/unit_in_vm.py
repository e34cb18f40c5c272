#!/usr/bin/env python3
"""Installs the Debian packages in a virtual machine and tries them under a real systemd.

    scripts/unit_in_vm.py [--build FOLDER] [--folder FOLDER] [--only NAME[,NAME...]]

Installs the packages aucast-data, au-transmitter and aucast-nats of a build (--build, default
build/release; `cpack -G DEB --config build/release/CPackConfig.cmake` makes them; aucast-nats needs
scripts/packages_nats.txt before the build) in a small Debian of this host's release, made by
debootstrap, and boots it in qemu, which emulates the processor: no /dev/kvm is needed, and nothing
of the guest touches this host. unit_in_vm_checks.py runs inside and says what held; at its end a
face-player of this host plays what the guest serves.
Needs root (for debootstrap), what packages_vm.txt lists, and up to ten minutes; with --folder the
Debian is kept there for the next run, which takes two minutes less.

Prints a line for each check and exits 1 when something did not hold. The console's log is printed
when the guest did not come to its end.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
OURS = ("aucast-data", "au-transmitter", "aucast-nats")
PACKAGES = ("curl", "dbus", "init-system-helpers", "linux-image-cloud-amd64", "openssl", "python3", "systemd",
            "systemd-sysv")
SECONDS_MAX = 1200  # for the guest, from its start to its end
DISK_BYTES = 2 << 30

# What server/GUIDE.md, "As a service", has an operator type, before the first boot.
AS_THE_README_SAYS = """set -e
dpkg -i /opt/packages/*.deb
install -D /usr/share/doc/aucast/au-transmitter.toml /etc/aucast/au-transmitter.toml
mkdir -p /var/lib/aucast/streams
cp /usr/share/aucast/streams/happiness.txt /var/lib/aucast/streams
systemctl -q enable au-transmitter systemd-networkd aucast-checks
"""

CHECKS_UNIT = """[Unit]
After=multi-user.target
SuccessAction=poweroff-force
FailureAction=poweroff-force
[Service]
Type=oneshot
WorkingDirectory=/opt/checks
ExecStart=python3 unit_in_vm_checks.py %s
StandardOutput=tty
TTYPath=/dev/ttyS1
[Install]
WantedBy=multi-user.target
"""

NETWORK = """[Match]
Type=ether
[Network]
DHCP=ipv4
"""


def run(*command, **more):
    """A command that must succeed; what it says is shown only when it does not."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def ours(build):
    """Our packages in a build."""
    found = [sorted((build / "packages").glob(f"{name}_*.deb")) for name in OURS]
    if not all(found):
        sys.exit(f"not in {build}/packages: {', '.join(OURS)}; "
                 f"cpack -G DEB --config {build}/CPackConfig.cmake")
    return [files[-1] for files in found]


def needed_by(packages):
    """What of Debian's own these depend on, as they say it."""
    said = ",".join(run("dpkg-deb", "-f", package, "Depends") for package in packages)
    needed = {need.strip() for need in said.split(",") if need.strip()}
    return ", ".join(sorted(need for need in needed if need.split()[0] not in OURS))


def make_debian(folder, needed):
    """A Debian of this host's release with what is needed, unless the folder has one."""
    done = folder / "packages"
    wanted = f"{','.join(PACKAGES)}; {needed}"
    if done.exists() and done.read_text(encoding="ascii") == wanted:
        return
    print("making a Debian", flush=True)
    shutil.rmtree(folder, ignore_errors=True)
    release = dict(line.rstrip().split("=", 1) for line in open("/etc/os-release", encoding="utf-8")
                   if "=" in line)["VERSION_CODENAME"]
    run("debootstrap", "--variant=minbase", f"--include={','.join(PACKAGES)}", release, folder)
    run("chroot", folder, "apt-get", "-qq", "update")
    run("chroot", folder, "apt-get", "-qq", "-y", "--no-install-recommends", "satisfy", needed,
        env=dict(os.environ, DEBIAN_FRONTEND="noninteractive"))
    done.write_text(wanted, encoding="ascii")


def make_disk(options, debian, folder):
    """The Debian with our packages installed as a disk."""
    print("installing the packages", flush=True)
    root = folder / "root"
    run("cp", "-a", "--reflink=auto", debian, root)
    (root / "opt/packages").mkdir()
    for package in ours(options.build):
        shutil.copy(package, root / "opt/packages")
    checks = root / "opt/checks"
    checks.mkdir()
    for path in ("scripts/unit_in_vm_checks.py", "tests/integration/independent_peer.py"):
        shutil.copy(ROOT / path, checks)
    (root / "etc/systemd/system/aucast-checks.service").write_text(CHECKS_UNIT % options.only,
                                                                  encoding="ascii")
    (root / "etc/hosts").write_text("127.0.0.1 localhost\n", encoding="ascii")
    (root / "etc/systemd/network/ether.network").write_text(NETWORK, encoding="ascii")
    run("chroot", root, "sh", "-c", AS_THE_README_SAYS)
    disk = folder / "disk"
    with open(disk, "wb") as file:
        file.truncate(DISK_BYTES)
    run("mke2fs", "-q", "-t", "ext4", "-d", root, disk)
    return disk


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as server:
        return server.getsockname()[1]


def play(options, port, folder):
    """A player of this host plays what the guest serves: a line as the guest writes them."""
    stats = folder / "stats.json"
    played = subprocess.run((options.build / "bin/face-player", "--headless", f"127.0.0.1:{port}",
                             "--stats", stats), stderr=subprocess.PIPE, text=True, timeout=120,
                            check=False)
    if played.returncode != 0:
        return f"FAILED player: exit code {played.returncode}, {played.stderr}"
    told = json.loads(stats.read_text(encoding="utf-8"))
    held = told["end_reason"] == "end_of_stream" and told["keyframes_played"] > 0
    return (f"{'ok    ' if held else 'FAILED'} player: one on another host played "
            f"{told['keyframes_played']} keyframes, {told['end_reason']}")


def boot(options, debian, disk, folder):
    """Runs the guest to its end: what it and the player on this host found, a line each."""
    port = free_port()
    console = folder / "console"
    kernel, initial = ((debian / name).resolve() for name in ("vmlinuz", "initrd.img"))
    print("booting", flush=True)
    guest = subprocess.Popen(
        ("qemu-system-x86_64", "-accel", "tcg", "-cpu", "max", "-m", "768", "-display", "none",
         "-no-reboot", "-kernel", kernel, "-initrd", initial,
         "-append", "root=/dev/vda rw console=ttyS0 quiet systemd.show_status=0",
         "-drive", f"file={disk},if=virtio,format=raw",
         "-nic", f"user,model=virtio-net-pci,restrict=on,hostfwd=tcp:127.0.0.1:{port}-:4650",
         "-chardev", f"file,id=console,path={console}", "-serial", "chardev:console",
         "-serial", "stdio"),
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True)
    timer = threading.Timer(SECONDS_MAX, guest.kill)
    timer.start()
    lines = []
    try:
        for line in guest.stdout:
            line = line.rstrip()
            if line == "PLAY":
                line = play(options, port, folder)
            print(f"  {line}", flush=True)
            lines.append(line)
    finally:
        timer.cancel()
        guest.kill()
        guest.wait()
    if "END" not in lines:
        print(console.read_text(encoding="utf-8", errors="replace"))
        lines.append("FAILED end: the guest did not come to its end")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0],
                                     epilog=__doc__.split("\n", 2)[2],
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--folder", type=pathlib.Path, help="keeps the Debian for the next run")
    parser.add_argument("--only", default="", help="names of checks, with commas between them")
    options = parser.parse_args()
    missing = [name for name in ("debootstrap", "qemu-system-x86_64", "mke2fs")
               if not shutil.which(name)]
    if missing:
        sys.exit(f"not here: {', '.join(missing)}; scripts/install_deps.sh scripts/packages_vm.txt")
    if os.geteuid() != 0:
        sys.exit("debootstrap needs root")
    needed = needed_by(ours(options.build))
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        debian = (options.folder or folder) / "debian"
        make_debian(debian, needed)
        lines = boot(options, debian, make_disk(options, debian, folder), folder)
    passed = sum(line.startswith("ok ") for line in lines)
    failed = sum(line.startswith("FAILED ") for line in lines)
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())
