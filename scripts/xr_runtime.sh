#!/usr/bin/env bash
# xr_runtime.sh [FOLDER]: fetches a real OpenXR runtime for the tests (Monado of Debian 13, drawing in software).
#
# Debian 12 has no OpenXR runtime. The packages of Debian 13 are fetched by the system's own apt, with its mirror, its
# proxy and its keys, but into FOLDER (build/xr-runtime) with lists and a package state of their own; they are unpacked
# there, not installed. Nothing of the system changes, nobody needs to be root. Programs run in it through Debian 13's
# dynamic loader (tests/monado/runtime.py). It takes half a minute the first time and no time after that.
# Exit codes: 0 it is there, 77 it cannot be had here (the reason is on stderr), 1 it broke.
set -euo pipefail
export LC_ALL=C.UTF-8
root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd)
folder=${1:-$root/build/xr-runtime}
release=trixie
packages=(monado-service libopenxr1-monado mesa-vulkan-drivers libegl1 libegl-mesa0 libgl1 libglx-mesa0 libepoxy0 libx11-6 libstdc++6)
keyring=/usr/share/keyrings/debian-archive-$release-stable.gpg
stamp="$release ${packages[*]}"

skip() { echo "skipped: $*" >&2; exit 77; }
# no_mirror REASON: many tests ask one after the other; for ten minutes they get the same answer without the wait
no_mirror() { echo "no mirror: $*" >"$folder/unavailable"; skip "no mirror: $*"; }

[[ -f $folder/stamp && $(<"$folder/stamp") == "$stamp" ]] && exit 0
[[ $(uname -m) == x86_64 ]] || skip "the runtime of the tests is set up for x86_64 only"
command -v apt-get >/dev/null && command -v dpkg >/dev/null || skip "not a Debian: there is no apt to fetch the runtime with"
[[ -f $keyring ]] || skip "no key to check Debian 13's packages with ($keyring: package debian-archive-keyring)"

# mirrors: addresses that the system's apt sources (either form) name for the archive itself
mirrors() {
    local codename file
    codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-stable}")
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [[ -f $file ]] && sed -nE "s/^deb +(\[[^]]*\] +)?([^ ]+) +$codename( .*)? main( .*)?$/\2/p" "$file"
    done
    for file in /etc/apt/sources.list.d/*.sources; do
        [[ -f $file ]] || continue
        awk -v codename="$codename" '
            function stanza_ends() { if (suites ~ " " codename " ") { n = split(uris, each, " "); for (i = 1; i <= n; ++i) print each[i] }; uris = suites = "" }
            /^[ \t]*$/ { stanza_ends() }
            tolower($1) == "uris:" { $1 = ""; uris = $0 }
            tolower($1) == "suites:" { $1 = ""; suites = $0 " " }
            END { stanza_ends() }' "$file"
    done
}

# One at a time; whoever comes second finds the stamp.
mkdir -p "$folder"
exec 9>"$folder/lock"
flock 9
[[ -f $folder/stamp && $(<"$folder/stamp") == "$stamp" ]] && exit 0

[[ -n $(find "$folder/unavailable" -mmin -10 2>/dev/null) ]] && skip "$(<"$folder/unavailable")"

mirror=$(mirrors | grep -vx '' | head -n 1) || no_mirror "none in the system's apt sources"
rm -rf "$folder"/{stamp,unavailable,lists,cache,root}
mkdir -p "$folder"/{lists/partial,cache/partial,root}
: >"$folder/status"
echo "deb [signed-by=$keyring] $mirror $release main" >"$folder/sources.list"
# Read after the system's settings, which it keeps (proxies, certificates), but for what would touch the system.
cat >"$folder/apt.conf" <<END_OF_SETTINGS
#clear APT::Update::Post-Invoke;
#clear APT::Update::Post-Invoke-Success;
#clear DPkg::Post-Invoke;
#clear DPkg::Pre-Install-Pkgs;
Dir::Etc::SourceList "$folder/sources.list";
Dir::Etc::SourceParts "/dev/null";
Dir::Etc::Preferences "/dev/null";
Dir::Etc::PreferencesParts "/dev/null";
Dir::State::Lists "$folder/lists";
Dir::State::status "$folder/status";
Dir::State::extended_states "$folder/extended_states";
Dir::Cache::Archives "$folder/cache";
Dir::Cache::pkgcache "";
Dir::Cache::srcpkgcache "";
Dir::Log "$folder/log";
APT::Architecture "amd64";
APT::Architectures { "amd64"; };
APT::Default-Release "";
APT::Install-Recommends "false";
APT::Install-Suggests "false";
APT::Sandbox::User "";
APT::Keep-Downloaded-Packages "true";
Acquire::Languages "none";
Acquire::Retries "3";
Acquire::http::Timeout "30";
Acquire::https::Timeout "30";
Debug::NoLocking "true";
END_OF_SETTINGS
apt=(apt-get -q -c "$folder/apt.conf")

echo "fetching the OpenXR runtime of the tests from $mirror"
"${apt[@]}" update >"$folder/apt.log" 2>&1 || { tail -n 3 "$folder/apt.log" >&2; no_mirror "$mirror did not give Debian 13's lists"; }
ls "$folder"/lists/*_Packages* >/dev/null 2>&1 || { tail -n 3 "$folder/apt.log" >&2; no_mirror "$mirror did not give Debian 13's lists"; }
"${apt[@]}" install -y --download-only "${packages[@]}" >>"$folder/apt.log" 2>&1 || {
    tail -n 5 "$folder/apt.log" >&2; no_mirror "$mirror did not give Debian 13's packages"; }
echo "unpacking $(ls "$folder"/cache/*.deb | wc -l) packages"
printf '%s\0' "$folder"/cache/*.deb | xargs -0 -P "$(nproc)" -n 8 sh -c 'out=$1; shift; for deb; do dpkg-deb -x "$deb" "$out" || exit 255; done' _ "$folder/root"
rm -rf "$folder"/{cache,lists}
echo "$stamp" >"$folder/stamp"
