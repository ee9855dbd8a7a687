//! The flank of a gear: what `gear_flank.eqn` states of its point, normal and curvatures, and the same in the frame of the rack.

assur::mechanism! {
    /// A flank cut by a rotating head, with its normal and curvatures alone: statements of `gear_flank.eqn`.
    GearFlank from "scene `addendum` of equations/src/gear_flank.eqn";

    /// Module, number of teeth.
    parameter m = 5 mm in 0.1 mm .. 100 mm, z = 20 in 1 .. 1e6;
    /// Radius of the convex arc, place of its centre, radius of the head.
    dimension ra = 5.75 mm in 0.1 mm .. 1 m, ca = 2.9635 mm in 1 um .. 1 m, R0 = 125 mm in 1 mm .. 1000 km;
    /// Number of blade groups, sense in which the head turns, angular place of the group.
    parameter z0 = 5 in 0 .. 100, q = 1 in -1 .. 1, delta = 0 rad in -100 rad .. 100 rad;
    /// Parameters of the flank: angle of the profile normal and angle of the head.
    parameter u = 27 deg in 0.001 deg .. 90 deg, th = 0 deg in -90 deg .. 90 deg;

    let rp = m*z/2;
    let rb = z0*m/2;
    let x(u) = -ca + ra*cos(u);
    let h(u) = ra*sin(u);
    let K(u) = -ra*cos(u);
    let e = 1;
    let R(u) = R0 + e*x(u);
    let x1(u) = diff(x(u), u);
    let h1(u) = diff(h(u), u);

    let thm = asin(-q*rb/R0);
    let yc = -q*rb;
    let X(u, th) = e*x(u)*cos(th) - 2*R0*sin((th + thm)/2)*sin((th - thm)/2) - q*rb*(th - thm - delta);
    let Y(u, th) = R(u)*sin(th) - yc;
    let rack(u, th) = [X(u, th), Y(u, th), h(u)];
    let n(u, th) = [-h1(u)*R(u)*cos(th), -h1(u)*(R(u)*sin(th) + q*rb), e*x1(u)*(R(u) + q*rb*sin(th))];

    let xF(u, th) = -K(u)*R(u)*cos(th)/(e*(R(u) + q*rb*sin(th)));
    let phi(u, th) = (xF(u, th) - X(u, th))/rp;
    let chain(u, th, roll) = roty(-roll)*(rack(u, th) + [rp*roll, 0, rp]);
    let flank(u, th) = chain(u, th, phi(u, th));
    let unit_n(u, th) = roty(-phi(u, th))*n(u, th)/norm(n(u, th));

    let r_u = diff(flank(u, th), u);
    let r_th = diff(flank(u, th), th);
    let n_u = diff(unit_n(u, th), u);
    let n_th = diff(unit_n(u, th), th);
    let E = inner(r_u, r_u);
    let F = inner(r_u, r_th);
    let G = inner(r_th, r_th);
    let L = -inner(n_u, r_u);
    let M = -(inner(n_u, r_th) + inner(n_th, r_u))/2;
    let N = -inner(n_th, r_th);
    let gauss = (L*N - M^2)/(E*G - F^2);
    let mean_k = (E*N - 2*F*M + G*L)/(2*(E*G - F^2));
    let spread = sqrt(max(mean_k^2 - gauss, 0));

    output r_gear = flank(u, th) [mm], n_gear = unit_n(u, th), K_gauss = gauss [1/mm^2], H_mean = mean_k [1/mm];
    output k1 = mean_k - spread [1/mm], k2 = mean_k + spread [1/mm];

    scene flank { sweep u 7.5 deg .. 51.5 deg, th -14.5 deg .. 3.5 deg; output r_gear, n_gear, K_gauss, H_mean, k1, k2; }

    // The same in the frame that does not turn, as by hand.
    let v = [-h(u), 0, X(u, th) + rp*phi(u, th)];
    let phi_u = diff(phi(u, th), u);
    let phi_th = diff(phi(u, th), th);
    let s_u = diff(rack(u, th), u) + phi_u*v;
    let s_th = diff(rack(u, th), th) + phi_th*v;
    let still = n(u, th);
    let m_u = diff(n(u, th), u) + phi_u*[-still.z, 0, still.x];
    let m_th = diff(n(u, th), th) + phi_th*[-still.z, 0, still.x];
    let E_s = inner(s_u, s_u);
    let F_s = inner(s_u, s_th);
    let G_s = inner(s_th, s_th);
    let L_s = -inner(m_u, s_u)/norm(still);
    let M_s = -inner(m_u, s_th)/norm(still);
    let N_s = -inner(m_th, s_th)/norm(still);
    let gauss_s = (L_s*N_s - M_s^2)/(E_s*G_s - F_s^2);
    let mean_s = (E_s*N_s - 2*F_s*M_s + G_s*L_s)/(2*(E_s*G_s - F_s^2));
    let spread_s = sqrt(max(mean_s^2 - gauss_s, 0));
    output K_still = gauss_s [1/mm^2], H_still = mean_s [1/mm];
    output k1_still = mean_s - spread_s [1/mm], k2_still = mean_s + spread_s [1/mm];

    scene still { sweep u 7.5 deg .. 51.5 deg, th -14.5 deg .. 3.5 deg; output r_gear, n_gear, K_still, H_still, k1_still, k2_still; }
}
