#!/bin/sh
# Sunflow 0.07.2 of Debian 12 inverts the colour of shadows of coloured glass. Shadow rays pass
# glass, and are multiplied by 1 - colour at each surface, so green glass has a magenta shadow. This
# light adds to the caustics of photons. Without absorption the colour is the default, grey, and
# clear glass passes a quarter of the light.
# A plate of glass hangs between a lamp and the floor; there are no photons, so that the floor should be black.
#
# Seen on Debian 12 with libsunflow-java 0.07.2.svn396+dfsg-18, light over that without glass, red, green, blue:
#     clear: 0.23 0.23 0.23
#     green, absorption.color .2 .9 .5: 0.62 0.01 0.23
#
# Needs apt-get, dpkg and a JDK. Exit status 0: it is so; 1: it has changed; 2: it could not be tried.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get download -qq libsunflow-java=0.07.2.svn396+dfsg-18 libjanino-java=2.7.0-2.1 2> download.log || exit 2
for package in *.deb; do dpkg -x "$package" root; done
cat > Mean.java <<'JAVA'
import org.sunflow.SunflowAPI;
import org.sunflow.core.Display;
import org.sunflow.image.Color;
public class Mean implements Display {
    float count;
    Color sum = new Color();
    public void imageBegin(int w, int h, int bucket) {}
    public void imagePrepare(int x, int y, int w, int h, int id) {}
    public synchronized void imageUpdate(int x, int y, int w, int h, Color[] data, float[] alpha) {
        for (Color color : data)
            sum.add(color);
        count += data.length;
    }
    public void imageFill(int x, int y, int w, int h, Color c, float alpha) {}
    public void imageEnd() {}
    public static void main(String[] files) {
        SunflowAPI scene = new SunflowAPI();
        Mean mean = new Mean();
        org.sunflow.system.UI.set(new org.sunflow.system.ui.SilentInterface());
        new org.sunflow.core.parser.SCParser().parse(files[0], scene);
        scene.render(SunflowAPI.DEFAULT_OPTIONS, mean);
        float[] rgb = mean.sum.mul(1 / mean.count).getRGB();
        System.out.println(rgb[0] + " " + rgb[1] + " " + rgb[2]);
    }
}
JAVA
draw() { java -cp root/usr/share/java/sunflow.jar:root/usr/share/java/janino.jar Mean.java "$1" 2> log || exit 2; }
cat > room.sc <<'SC'
image { resolution 8 8 aa 0 0 samples 1 filter box }
camera { type pinhole eye 0 0 .4 target 0 0 0 up 0 1 0 fov 40 aspect 1 }
shader { name white type diffuse diff { "sRGB linear" 1 1 1 } }
light { type point color { "sRGB linear" 1 1 1 } power 1000 p .13 .07 4 }
object { shader white type generic-mesh name floor points 4 -5 -5 0 5 -5 0 5 5 0 -5 5 0 triangles 2 0 1 2 0 2 3
  normals none uvs none }
SC
cat > plate <<'SC'
object { shader glass type generic-mesh name plate
  points 8 -3 -3 .5 3 -3 .5 3 3 .5 -3 3 .5 -3 -3 1.5 3 -3 1.5 3 3 1.5 -3 3 1.5
  triangles 12 0 2 1 0 3 2 4 5 6 4 6 7 0 1 5 0 5 4 1 2 6 1 6 5 2 3 7 2 7 6 3 0 4 3 4 7 normals none uvs none }
SC
echo 'shader { name glass type glass eta 1.5 color { "sRGB linear" 1 1 1 } }' > clear
echo 'shader { name glass type glass eta 1.5 color { "sRGB linear" 1 1 1 } absorption.distance 1' \
    'absorption.color { "sRGB linear" .2 .9 .5 } }' > green
open=$(draw room.sc)
for glass in clear green; do
    cat room.sc $glass plate > covered.sc
    draw covered.sc | awk -v open="${open%% *}" '{ printf "%.2f %.2f %.2f\n", $1 / open, $2 / open, $3 / open }'
done > found
sed '1s/^/clear: /; 2s/^/green, absorption.color .2 .9 .5: /' found
awk 'NR == 1 { grey = $1 > .2 && $1 < .26 && $2 == $1 } NR == 2 { magenta = $1 > .55 && $2 < .05 } END { exit !(grey && magenta) }' found
