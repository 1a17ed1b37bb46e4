#!/bin/sh
# OpenImageIO 2.4.7 leaves the EXPOSURE of a Radiance picture out of its pixels. By Radiance's manual the line says by how
# much pixels were multiplied, and a reader divides by it to get W/(sr m2). The number is kept as metadata, hdr:exposure,
# where few look for it, and an EXR made of the picture lacks it. An environment map that Radiance's tools exposed then
# lights a scene by a wrong factor, here 4.
#
# Seen on Debian 12 with openimageio-tools 2.4.7.1+dfsg-2:
#     radiance .5 in the file, Pixel (0, 0): 2.000000000 2.000000000 2.000000000
#
# Needs apt-get, dpkg and 60 MB of packages. Exit status 0: it is so; 1: it has changed; 2: it could not be tried.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
packages=$(apt-get install -s --reinstall --no-install-recommends openimageio-tools=2.4.7.1+dfsg-2 |
    sed -n 's/^Inst \([^ ]*\) .*/\1/p') || exit 2
apt-get download -qq $packages 2> download.log || exit 2
for package in *.deb; do dpkg -x "$package" root; done
# One texel: mantissas 128 of 256, exponent 130 - 128.
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=4\n\n-Y 1 +X 1\n\200\200\200\202' > sky.hdr
library=$folder/root/usr/lib/x86_64-linux-gnu
export LD_LIBRARY_PATH="$library:$library/blas:$library/lapack:$library/pulseaudio"
root/usr/bin/oiiotool --dumpdata sky.hdr > log 2>&1 || exit 2
echo "radiance .5 in the file,$(sed -n 's/^ *Pixel/ Pixel/p' log)"
grep -q 'Pixel (0, 0): 2.000000000 2.000000000 2.000000000' log
