#!/usr/bin/env bash
# Builds the fuzz targets with clang, address and undefined-behaviour sanitizers, and runs each for a time:
#   bash tests/fuzz/run.sh [SECONDS [TARGET…]]     60 seconds each of all, if left out
# Inputs found are kept in build/fuzz/corpus, failing ones in build/fuzz/found; what is printed in the end
# is in build/fuzz/report.txt, too. The exit code is 1 if a target failed.
set -uo pipefail
cd "$(dirname "$0")/../.."
seconds=${1:-60}
shift || true
targets=(${*:-meshes scenes run_files xml_surfaces velocity_fields filters})
mkdir -p build
cmake --preset fuzz > build/fuzz.log 2>&1 || { cat build/fuzz.log >&2; exit 1; }
cmake --build --preset fuzz --target "${targets[@]/#/fuzz_}" || exit 1

folder=build/fuzz
[ -z "${TMPDIR:-}" ] && [ -d /dev/shm ] && export TMPDIR=/dev/shm # files that nobody keeps
report=$folder/report.txt
mkdir -p $folder/found
printf '%-13s %12s %8s %10s %10s %9s %s\n' target executions seconds branches features memory result | tee $report
failed=0
for target in "${targets[@]}"; do
  corpus=$folder/corpus/$target
  mkdir -p "$corpus"
  cp "tests/fuzz/seeds/$target/"* "$corpus"
  [ "$target" = scenes ] && cp data/scenes/*.toml "$corpus"
  # One thread, since what a thread pool does isn't the same twice. With sanitizers numerics take 80 times as
  # long, files 10 times: 60 s here are less than 10 s without.
  OPENBLAS_NUM_THREADS=1 ASAN_OPTIONS=allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1 \
    $folder/bin/fuzz_"$target" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=2048 -max_len=4096 \
    -len_control=0 -print_final_stats=1 -artifact_prefix=$folder/found/"$target"- "$corpus" > $folder/"$target".log 2>&1
  code=$?
  [ $code = 0 ] || failed=1
  log=$folder/$target.log
  stat() { sed -n "s/^stat::$1: *//p" "$log" | tail -1; }
  # libFuzzer's last line: "#N DONE cov: branches ft: features …", of the branches that were instrumented.
  last=$(grep -a 'cov: ' "$log" | tail -1)
  all=$(sed -n 's/^INFO: Loaded .* (\([0-9]*\) inline.*/\1/p' "$log" | tail -1)
  number() { sed -n "s/.*$1: \([0-9]*\).*/\1/p" <<< "$last"; }
  took=$(sed -n 's/^Done .* runs in \([0-9]*\) second.*/\1/p' "$log")
  printf '%-13s %12s %8s %10s %10s %6s MB %s\n' "$target" "$(stat number_of_executed_units)" "${took:--}" \
    "$(number cov)/$all" "$(number ft)" "$(stat peak_rss_mb)" \
    "$([ $code = 0 ] && echo clean || grep -aE 'SUMMARY|what\(\)' "$log" | head -1)" | tee -a $report
done
exit $failed
