# Runs inside the virtual machine, by busybox sh: devices from their plugging in to their end.
. /steps.sh

# follow KIND NAME: opens the device, follows a groove, is unplugged in the middle of it.
follow() {
  echo "-- $2: follow a groove, then unplug"
  plug "$1"
  /follow /data/devices/profiles "$2" >/tmp/follow.log 2>&1 &
  follower=$!
  wait_for "$2 to have followed" grep -q "held within" /tmp/follow.log
  unplug
  wait "$follower" || fail "follow $2"
  cat /tmp/follow.log
}

follow pid openffboard
grep -q 'set 11 01' /tmp/pid.log || fail "no effect was created"
follow pid-array vpforce-rhino
follow moontrace-raw moontrace-raw

echo "-- the list of devices"
plug pid
/moontrace devices >/tmp/devices.log 2>&1 || fail "moontrace devices"
grep openffboard /tmp/devices.log || fail "moontrace devices does not list the stick"
unplug

echo "-- the loop: feel a page on the stick; unplug it, plug it in again"
plug pid
/moontrace loop "ab" --device openffboard --seconds 2 --json >/tmp/loop.json 2>/tmp/loop.log ||
  fail "moontrace loop"
grep -o '"ticks":[0-9]*,"lost_ticks":[0-9]*' /tmp/loop.json
# The page was felt, on real reports, and the program left the motors at zero and off.
grep -q '"device_lost":0' /tmp/loop.json || fail "the device was lost"
grep -q '"touching":1.0' /tmp/loop.json || fail "the page was not touched"
[ "$(grep -c force /tmp/pid.log)" -gt 100 ] || fail "no force reached the stick"
grep force /tmp/pid.log | tail -n 1 | grep -q 'force 0.000000 0.000000' || fail "force was left on"
grep 'out 0c' /tmp/pid.log | tail -n 1 | grep -q 'out 0c 02' || fail "the motors were left on"

/moontrace loop "ab" --device openffboard --seconds 3 >/tmp/loop.log 2>&1 &
loop=$!
wait_for "the loop to run" grep -q Running /tmp/loop.log
unplug
wait_for "the loop to notice" grep -q "Device lost" /tmp/loop.log
/uhid_device pid >/tmp/again.log 2>&1 &
device=$!
wait "$loop" || fail "moontrace loop, unplugged"
grep "Device" /tmp/loop.log
grep -q "Device back" /tmp/loop.log || fail "the device did not come back"
unplug
