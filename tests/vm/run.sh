#!/bin/sh
# run.sh WORK SOURCE INSIDE SECONDS PROGRAM...: boots Debian's kernel under QEMU with the programs and their
# libraries in its first file system and runs the script INSIDE there, as root, with emulated HID
# devices behind the kernel's uhid, for so long at most. WORK keeps what was downloaded. Exit 77: this machine lacks
# something, which is said.
set -eu
work=$1 source=$2 inside=$3 seconds=$4
shift 4

skip() {
  echo "skipped: $*"
  exit 77
}

for tool in qemu-system-x86_64 apt-get apt-cache dpkg-deb gzip; do
  command -v "$tool" >/dev/null || skip "$tool is missing (./moontrace packages ci)"
done
[ "$(uname -m)" = x86_64 ] || skip "this machine is no x86-64"

mkdir -p "$work"
cd "$work"
if [ ! -e kernel/done ]; then
  image=$(apt-cache depends linux-image-cloud-amd64 2>/dev/null | awk '/Depends/ {print $2; exit}')
  [ -n "$image" ] || skip "apt knows no linux-image-cloud-amd64 (apt-get update)"
  rm -rf kernel ./*.deb
  timeout 100 apt-get -q download busybox-static "$image" >download.log 2>&1 ||
    skip "Debian's kernel package could not be downloaded"
  mkdir kernel
  for package in *.deb; do dpkg-deb -x "$package" kernel; done
  touch kernel/done
fi
busybox=$work/kernel/bin/busybox

root=$work/root
rm -rf "$root"
mkdir -p "$root/bin" "$root/dev" "$root/proc" "$root/sys" "$root/tmp" "$root/data/devices"
cp "$busybox" "$root/bin/busybox"
cp -r "$source/devices/profiles" "$source"/devices/*.toml "$root/data/devices/"
cp -r "$source/models" "$root/data/"
mkdir "$root/data/textures"
cp -r "$source/textures/scripts" "$root/data/textures/"
cp "$inside" "$root/inside.sh"
cp "$source/tests/vm/steps.sh" "$root/"
for module in hid hid-generic uhid; do
  find kernel -path "*/kernel/drivers/hid/$module.ko" -exec cp {} "$root/" \;
done
for program in "$@"; do
  cp "$program" "$root/"
  ldd "$program" | grep -o '/[^ ]*' | while read -r library; do
    mkdir -p "$root${library%/*}"
    [ -e "$root$library" ] || cp -L "$library" "$root$library"
  done
done
mkdir -p "$root/libexec" && mv "$root"/moontrace-guardian "$root/libexec/"  # as it is installed
cat >"$root/init" <<'END'
#!/bin/busybox sh
/bin/busybox --install -s /bin
export PATH=/bin HOME=/tmp
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t devtmpfs dev /dev
for module in hid hid-generic uhid; do insmod "/$module.ko" || echo "no module $module"; done
sh /inside.sh
echo "VM-RESULT $?"
poweroff -f
END
chmod +x "$root/init"
(cd "$root" && find . | "$busybox" cpio -o -H newc 2>/dev/null | gzip -1) >initrd.gz

# In software, which works everywhere, with time by instructions (-icount): however busy this machine
# is, the same happens inside.
timeout "$seconds" qemu-system-x86_64 -M q35 -accel tcg -icount shift=3,sleep=off -cpu max -smp 1 -m 768 \
  -nodefaults -no-user-config -display none -serial stdio -no-reboot -net none \
  -kernel kernel/boot/vmlinuz-* -initrd initrd.gz \
  -append "console=ttyS0 quiet panic=-1 tsc=unstable mitigations=off" </dev/null 2>&1 |
  tee console.log
grep -q 'VM-RESULT 0' console.log
