//! Events with names, one of them in each of two modes, and the rate of a point. The facts are tests that the macro emits.

mod ball {
    assur::mechanism! {
        /// A ball that jumps as high as it has fallen, without modes.
        Ball from "closed form";

        parameter g = 10 [m/s^2], m = 1 kg;
        coordinate x: m = 1 m;
        kinetic m*dot(x)^2/2;
        potential m*g*x;
        when hit: x falls { set dot(x) = -dot(x); }

        measure hits = count(hit);
        measure speed = value(dot(x), before(hit)), again = value(dot(x), last(after(hit)));
        point P = [0 m, x];
        measure fastest = peak(dot(P).y);
        output x, dot(P).y;
        scene fall { run time 0 s .. 3 s; }
        expect at time = 0.3 s: dot(P).y = -3 [m/s] +- 1e-6 [m/s];
        expect at run: fastest = 4.4721359549996 [m/s] +- 1e-6 [m/s];
        expect at run: hits = 3 +- 0.01;
        expect at run: speed = -4.4721359549996 [m/s] +- 1e-6 [m/s];
        expect at run: again = 4.4721359549996 [m/s] +- 1e-6 [m/s];
    }
}

mod pendulum {
    assur::mechanism! {
        /// A mass between two springs that takes turns between them.
        Springs from "closed form";

        parameter m = 1 kg, c = 1 [N/m];
        coordinate x: m = 1 m;
        mode right { motion m*ddot(x) = -c*x; when middle: x falls -> left; }
        mode left { motion m*ddot(x) = -c*x; when middle: x rises -> right; }

        measure passes = count(middle), entries = count(enter(left));
        output x;
        scene swing { run time 0 s .. 12 s; }
        expect at run: passes = 4 +- 0.01;
        expect at run: entries = 2 +- 0.01;
    }
}
