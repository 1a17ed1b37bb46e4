#!/bin/sh
# The program sunflow of Debian 12 opens no scene. Its library was built without the parts that read
# files by their names.
# The command line ends with an exception for a .sc file. The parser of .sc files is still in the
# library, as the class org.sunflow.core.parser.SCParser, for programs that call it.
#
# Seen on Debian 12 with sunflow 0.07.2.svn396+dfsg-18:
#     java.lang.UnsupportedOperationException: Removed parser support  from SunFlow
#
# Needs apt-get, dpkg and a JDK. Exit status 0: it is so; 1: it has changed; 2: it could not be tried.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq sunflow=0.07.2.svn396+dfsg-18 libsunflow-java=0.07.2.svn396+dfsg-18 libjanino-java=2.7.0-2.1 2> download.log || exit 2
for package in *.deb; do dpkg -x "$package" root; done
cat > ball.sc <<'SC'
image { resolution 16 16 aa 0 0 samples 1 filter box }
camera { type pinhole eye 0 -4 0 target 0 0 0 up 0 0 1 fov 40 aspect 1 }
shader { name white type constant color { "sRGB linear" 1 1 1 } }
object { shader white type sphere name ball c 0 0 0 r 1 }
SC
sed 's,"/usr/share,"'"$folder/root"'/usr/share,; s,:/usr/share,:'"$folder/root"'/usr/share,' root/usr/bin/sunflow > sunflow
sh ./sunflow -nogui -o ball.png ball.sc > log 2>&1 || true
grep -o 'java.lang.UnsupportedOperationException: Removed parser support.*' log
[ ! -e ball.png ]
