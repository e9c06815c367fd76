# Runs inside the virtual machine, by busybox sh: programs that push real hidraw nodes are killed and
# stopped, and their guardians let go.
. /steps.sh

ended() { [ "$(grep -c . /tmp/push.log)" -ge 2 ]; }
none_guards() { ! pidof moontrace-guardian >/dev/null; }

table() {
  for way in kill segv abort stop; do
    grep "^$way" /tmp/guarded | awk '{print $2}' | sort -n |
      awk -v way=$way '{a[NR] = $1} END {print way, NR, "times, median", a[int((NR + 1) / 2)], "ms, most", a[NR], "ms"}'
  done
}

# guarded KIND NAME COUNT: COUNT times a program pushes the device and ends in one of four ways; what
# the device was told last must be zero, in time. Of a stick every effect counts.
guarded() {
  echo "-- $2: let go of by its guardian"
  for number in $(seq "$3"); do
    case $((number % 4)) in 0) way=kill ;; 1) way=segv ;; 2) way=abort ;; *) way=stop ;; esac
    plug "$1"
    /push_device /data/devices/profiles "$2" "$way" $((21 + number * 7 % 40)) >/tmp/push.log 2>&1 &
    pusher=$!
    wait_for "$2 to be let go of ($way)" ended
    sleep 0.1
    awk -v kind="$1" -v way="$way" -v ended="$(awk 'NR == 2 {printf "%.3f", 1000 * $1}' /tmp/push.log)" '
      function number(hex) { return hex == "00" ? 0 : 1 }
      NR == 1 { began = $1; next }
      $2 != "out" { next }
      kind == "pid" && $3 == "05" { force[$4] = number($5) + number($6) }
      kind == "pid" && $3 == "0a" && $5 == "03" { force[$4] = 0 }
      kind != "pid" { force[0] = 0; if (number($4)) for (i = 7; i <= 18; ++i) force[0] += number($i) }
      { sum = 0; for (i in force) sum += force[i] }
      sum > 0 { pushed = 1; zero = -1 }
      sum == 0 && zero < 0 { zero = began + $1 }
      END {
        late = zero - ended
        good = pushed && zero > 0 && late < (way == "stop" ? 25 : 5)
        printf "%s %.2f ms %s\n", way, late, good ? "" : "TOO LATE"
        exit !good
      }' "/tmp/$1.log" >>/tmp/guarded || fail "$2 was not let go of: $(tail -n 1 /tmp/guarded)"
    kill -9 $pusher 2>/dev/null
    wait $pusher 2>/dev/null
    wait_for "the guardian to end" none_guards
    unplug
    [ $((number % 20)) -gt 0 ] || table
  done
  [ $((number % 20)) -eq 0 ] || table
  rm /tmp/guarded
}

# In CI a few: a machine that is emulated is slow. The table in the pages is of more.
guarded pid openffboard 8
guarded moontrace-raw moontrace-raw 8
