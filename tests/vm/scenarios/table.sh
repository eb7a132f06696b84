# A table on its way into a native bridge: uploaded, read back, rolled back, cut off on the way.
serial=SIM-0001
device=(--device "hid:$serial")

upload() { "$cli" device upload "${device[@]}" --model "$MODEL" --force "$@"; }
# Two tables of the same model.
upload_old() { upload --bound 0.01; }
upload_new() { upload --bound 0.01 --kind float; }
read_table() { "$cli" device read-table "${device[@]}" --out "$1"; }
in_use() { read_table now.bin && cmp now.bin "$1"; }
old_or_new() { read_table now.bin && { cmp now.bin old.bin || cmp now.bin new.bin; }; }
cut_at() {
    [ "$(tell cut "$1")" = ok ] && ! upload_new 2>said.txt && ! hidraw_of "$serial" >&2
}

check "the bridge is plugged in" start_device bridge "$serial"
check "info names the gyro" eval '"$cli" device info "${device[@]}" | tee info.txt | grep -q L3GD20H'
check "no table is in use" eval '! read_table none.bin'
check "a table is uploaded" upload_old
check "it is read back" read_table old.bin
check "another table is uploaded" upload_new
check "it is in use" eval 'read_table new.bin && ! cmp -s new.bin old.bin'
check "rollback" "$cli" device rollback "${device[@]}"
check "the first one is in use again" in_use old.bin

# While it looks at the device, while the chunks go, and near the end.
for exchange in 4 20 45; do
    check "unplugged at exchange $exchange the upload fails" cut_at "$exchange"
    check "it says so" grep -q "was unplugged" said.txt
    check "plugged in again" plug "$serial"
    check "the old or the new table is in use, whole" old_or_new
done
check "the new table is uploaded after all" upload_new
check "it is in use" in_use new.bin
