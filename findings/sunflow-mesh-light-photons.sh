#!/bin/sh
# Sunflow 0.07.2 of Debian 12 halves the power of the photons of a lamp that is a rectangle. A mesh
# light of n triangles chooses one of them by its area, and its photon has the power of that
# triangle, not of the lamp: n equal triangles emit 1/n of the light. The direct light of the lamp
# is right, only caustics and photon maps are too dark.
# The lamp looks down at a mirror, which alone lights the ceiling that the camera sees.
#
# Seen on Debian 12 with libsunflow-java 0.07.2.svn396+dfsg-18, light over L A cos^2 / (pi d^2):
#     one triangle: 1.03
#     two triangles: 0.48
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
image { resolution 16 16 aa 0 0 samples 1 filter box }
trace-depths { diff 1 refl 4 refr 4 }
camera { type pinhole eye 0 0 .5 target 0 0 1 up 0 1 0 fov 20 aspect 1 }
shader { name white type diffuse diff { "sRGB linear" 1 1 1 } }
shader { name mirror type mirror refl { "sRGB linear" 1 1 1 } }
object { shader white type generic-mesh name above points 4 -5 5 1 5 5 1 5 -5 1 -5 -5 1 triangles 2 0 1 2 0 2 3 normals none uvs none }
object { shader mirror type generic-mesh name below points 4 -5 -5 -1 5 -5 -1 5 5 -1 -5 5 -1 triangles 2 0 1 2 0 2 3 normals none uvs none }
photons { caustics 20000 kd 100 1 }
SC
mesh='light { type meshlight name lamp emit { "sRGB linear" 1 1 1 } radiance 1000 samples 16'
echo "$mesh points 3 1 0 0 1 .4 0 1.2 0 0 triangles 1 0 1 2 }" > one
echo "$mesh points 4 1 0 0 1 .2 0 1.2 .2 0 1.2 0 0 triangles 2 0 1 2 0 2 3 }" > two
for lamp in one two; do
    cat room.sc $lamp > lit.sc
    draw lit.sc | awk -v lamp=$lamp '{ d2 = 9 + 1.1^2 + .1^2; printf "%s: %.2f\n", lamp, $1 * 3.14159 * d2 * d2 / (1000 * .04 * 9) }'
done > found
sed 's/one/one triangle/; s/two/two triangles/' found
awk -F': ' '/one/ { one = $2 } /two/ { two = $2 } END { exit !(one > .9 && one < 1.1 && two / one > .45 && two / one < .55) }' found
