#!/bin/sh
# Sunflow 0.07.2 of Debian 12: a point light emits too many photons along the z axis of the scene.
# Its directions have half the sine that they need, and so the caustics of a point lamp are four
# times too bright above and below it, and by the formula half as bright beside it. Direct light is
# the same to all sides. A ball lamp of the same power is right.
# The lamp is 1 m above a mirror and 1 m below a ceiling: the mirror adds 1/9 to the ceiling's light.
#
# Seen on Debian 12 with libsunflow-java 0.07.2.svn396+dfsg-18, light over that without the mirror's:
#     spherical: 1.10
#     point: 1.42
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
SC
echo 'light { type spherical color { "sRGB linear" 1 1 1 } radiance 10000 center 0 0 0 radius .05 samples 16 }' > spherical
echo 'light { type point color { "sRGB linear" 1 1 1 } power 986.96 p 0 0 0 }' > point
for lamp in spherical point; do
    cat room.sc $lamp > dark.sc
    { cat dark.sc; echo "photons { caustics 10000 kd 100 1 }"; } > lit.sc
    direct=$(draw dark.sc)
    draw lit.sc | awk -v direct="${direct%% *}" -v lamp=$lamp '{ printf "%s: %.2f\n", lamp, $1 / direct }'
done > found
cat found
awk -F': ' '/spherical/ { right = $2 < 1.13 && $2 > 1.09 } /point/ { wrong = $2 > 1.38 } END { exit !(right && wrong) }' found
