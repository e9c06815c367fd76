# What the scripts inside the virtual machine share. Every step must succeed.
fail() {
  echo "FAILED: $*"
  tail -n 20 /tmp/*.log
  exit 1
}

wait_for() { # wait_for WHAT COMMAND...: at most 20 s
  what=$1
  shift
  for _ in $(seq 200); do
    "$@" && return 0
    sleep 0.1
  done
  fail "waited in vain for $what"
}

# plug KIND: its process is $device, its log /tmp/KIND.log
plug() {
  rm -f /tmp/*.log
  /uhid_device "$1" >"/tmp/$1.log" 2>&1 &
  device=$!
  wait_for "/dev/hidraw0" test -e /dev/hidraw0
}

unplug() {
  kill "$device"
  wait "$device" 2>/dev/null
  wait_for "the node to go" test ! -e /dev/hidraw0
}

export MOONTRACE_DATA=/data
