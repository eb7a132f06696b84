# The kernel for the virtual machine, for `run`.

# The modules that the guest needs, in this order, each after those that it needs itself; the last ones are
# loaded by scenarios.
vm_modules=(virtio_pci 9pnet_virtio 9p overlay hid-generic uhid)
vm_late_modules=(hid-mcp2221)

# The package that Debian's newest kernel is in, by the name under which it can always be asked for.
kernel_package() {
    apt-cache depends linux-image-amd64 2>/dev/null | awk '/Depends: linux-image-/ { print $2; exit }'
}

# The kernel is the compressed part of the image. As an ELF file it starts at once, without unpacking itself.
unpacked_kernel() {
    local image=$1 start
    start=$(grep -abo -m 1 -P '\xfd7zXZ\x00' "$image" | head -n 1 | cut -d : -f 1)
    if [ -n "$start" ]; then
        # What follows the kernel in the image is not for xz, which complains of it.
        tail -c "+$((start + 1))" "$image" | xz -dc 2>/dev/null || true
        return
    fi
    start=$(grep -abo -m 1 -P '\x28\xb5\x2f\xfd' "$image" | head -n 1 | cut -d : -f 1)
    [ -n "$start" ] && { tail -c "+$((start + 1))" "$image" | zstd -dc 2>/dev/null || true; }
}

# copy_modules UNPACKED VERSION FOLDER: numbered as they must be loaded; those for later without a number.
copy_modules() {
    local unpacked=$1 version=$2 folder=$3 module path number=100
    depmod -b "$unpacked" "$version"
    mkdir -p "$folder"
    for module in "${vm_modules[@]}"; do
        while read -r _ path _; do
            [ ! -f "$folder"/*-"$(basename "$path")" ] || continue
            cp "$path" "$folder/$number-$(basename "$path")"
            number=$((number + 1))
        done < <(modprobe -d "$unpacked" -S "$version" --show-depends "$module" | grep '^insmod')
    done
    for module in "${vm_late_modules[@]}"; do
        find "$unpacked/lib/modules/$version" -name "$module.ko" -exec cp {} "$folder/" \;
    done
}

# unpack_kernel PACKAGE_FILE FOLDER: vmlinux and modules/.
unpack_kernel() {
    local unpacked version
    unpacked=$(mktemp -d "$2.XXXXXX")
    dpkg-deb -x "$1" "$unpacked"
    version=$(ls "$unpacked/lib/modules")
    copy_modules "$unpacked" "$version" "$unpacked/result/modules"
    unpacked_kernel "$unpacked/boot/vmlinuz-$version" >"$unpacked/result/vmlinux"
    mv "$unpacked/result" "$2"
    rm -rf "$unpacked"
}

# prepared_kernel CACHE: downloads and unpacks what is missing there, and prints the folder; else prints why
# not, and fails.
prepared_kernel() {
    local cache=$1 package
    exec 9>"$cache/lock"
    flock 9
    package=$(kernel_package)
    if [ -z "$package" ]; then
        echo "apt knows no linux-image-amd64 here (apt-get update?)"
        return 1
    fi
    if [ ! -d "$cache/$package" ]; then
        echo "vm: downloading $package into $cache" >&2
        if ! (cd "$cache" && apt-get download -qq "$package" >&2); then
            echo "$package can't be downloaded"
            return 1
        fi
        unpack_kernel "$cache/$package"_*.deb "$cache/$package" >&2
        rm "$cache/$package"_*.deb
    fi
    if [ ! -s "$cache/$package/vmlinux" ]; then
        echo "no kernel was found in $package"
        return 1
    fi
    echo "$cache/$package"
}
