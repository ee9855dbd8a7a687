"""The polynomial of degree 9 whose roots are lengths of the rocker O3-D for which the squares of the misfit of the dyad C-D-O3 are
least: all its roots for the test vector of the specification (task 4a), with 80 digits, for `solvers/src/synthesis/fit/tests.rs`.

    python3 tests/reference/dwell_polynomial.py
"""
from mpmath import mp, mpf, matrix, cos, sin, acos, atan2, sqrt, pi, polyroots, qr, lu_solve, fabs
mp.dps=80
def psi_req():
    # inverse of the rack unit
    La,Lc,Ld=mpf(32),mpf(28),mpf(24); b=(mpf(84),mpf(-24)); q=(mpf(36),mpf(5)); Ov=(mpf(112),mpf(32))
    T=mpf(4);php=120*pi/180;phv=60*pi/180;ppl=mpf('0.2');px=mpf(3)
    Ax=T/(2*sin(php/2)); D1=(php-phv)/2; D2=pi-php/2
    g1=2*ppl*D2/(px*D1); a5=8*(1-g1)/3+g1; a4=-(1-g1)/3-3*a5; a3=-4*a4-10*a5
    def circ(P,r,Q,R,m):
        dx,dy=Q[0]-P[0],Q[1]-P[1]; d=sqrt(dx*dx+dy*dy); a=(r*r-R*R+d*d)/(2*d); h=sqrt(r*r-a*a)
        # sign(cross(Q-P,X-P))=m
        return (P[0]+a*dx/d-m*h*dy/d, P[1]+a*dy/d+m*h*dx/d)
    def psi(phi):
        p=fabs(phi)
        X=Ax*sin(phi)
        if p<=phv/2: Y=ppl
        elif p<=php/2:
            u=(p-phv/2)/D1; Y=ppl*(1-2*u**3+u**4)
        else:
            w=(p-php/2)/D2; Y=-px*(g1*w+a3*w**3+a4*w**4+a5*w**5)
        Q=(36+X,37-ppl+Y)
        qa=sqrt(q[0]**2+q[1]**2)
        # A = circ(O_h, La, Q, |q|, m) continuous with A=(0,32) where Q=(36,37): cross(Q,A)=36*32-37*0>0
        A=circ((mpf(0),mpf(0)),La,Q,qa,1)
        gam=atan2(Q[1]-A[1],Q[0]-A[0])-atan2(q[1],q[0])
        B=(A[0]+cos(gam)*b[0]-sin(gam)*b[1],A[1]+sin(gam)*b[0]+cos(gam)*b[1])
        # C = circ(O_v, Lc, B, Ld): reference O_v=(112,32), B=(84,8), C=(84,32): cross(B-Ov, C-Ov)= (-28,-24)x(-28,0) = -28*0-(-24)(-28) = -672
        C=circ(Ov,Lc,B,Ld,-1)
        beta=atan2(C[1]-Ov[1],C[0]-Ov[0])
        if beta<0: beta+=2*pi
        return pi-beta
    return psi
psi=psi_req()
def coeffs(M1,N=36):
    phi0,psi0,L1,L2,L3,L4,eta=map(mpf,('0.6','2.9','8','60','50','70','0.9'))
    O3=(mpf(36),mpf(96)); rows=[]
    for i in range(N):
        phi=10*i*pi/180
        if phi>pi: phi-=2*pi
        A=(L1*cos(phi0+phi),L1*sin(phi0+phi)); O2=(L4*cos(eta),L4*sin(eta))
        dx,dy=O2[0]-A[0],O2[1]-A[1]; d=sqrt(dx*dx+dy*dy)
        th=atan2(dy,dx)+M1*acos((L2*L2+d*d-L3*L3)/(2*L2*d))
        P=psi0-psi(phi); e=(cos(P),sin(P)); E=(A[0]-O3[0],A[1]-O3[1])
        c,s=cos(th),sin(th)
        f=(c*E[0]+s*E[1],-s*E[0]+c*E[1]); g=(c*e[0]+s*e[1],-s*e[0]+c*e[1]); h=e[0]*E[0]+e[1]*E[1]
        rows.append((E[0]**2+E[1]**2,f,g,h))
    return rows
def solve(rows,r):
    n=len(rows); G=matrix(3,3); b=matrix(3,1)
    K=[]; K2=[]
    for E2,f,g,h in rows:
        col=(mpf(1),2*(f[0]-r*g[0]),2*(f[1]-r*g[1])); y=-(E2-2*r*h)
        K.append(col);K2.append(y)
    for i in range(3):
        b[i]=sum(K[k][i]*K2[k] for k in range(n))
        for j in range(3): G[i,j]=sum(K[k][i]*K[k][j] for k in range(n))
    x=lu_solve(G,b)
    res=[sum(K[k][i]*x[i] for i in range(3))-K2[k] for k in range(n)]
    det=mp.det(G)
    # dS/dr at optimum: 2 sum res * dDq/dr, Dq = col.x - y ; d/dr = -2 g.c - 2 h
    dS=2*sum(res[k]*(-2*rows[k][3]-2*(x[1]*rows[k][2][0]+x[2]*rows[k][2][1])) for k in range(n))
    return x,res,det,dS
def poly(rows):
    # p(r)=dS*det^2/scale, interpolate on 12 points -> degree should be 9
    pts=[mpf(10*k-55) for k in range(12)]
    vals=[]
    for r in pts:
        x,res,det,dS=solve(rows,r); vals.append(dS*det**2)
    # Newton divided differences to monomials
    n=len(pts); V=matrix(n,n)
    for i in range(n):
        for j in range(n): V[i,j]=pts[i]**j
    return lu_solve(V,matrix(vals))
for M1 in (1,-1):
    rows=coeffs(M1); c=poly(rows)
    print('M1',M1); m=max(fabs(v) for v in c)
    print([mp.nstr(v/m,6) for v in c])
    roots=polyroots([c[9-k] for k in range(10)],maxsteps=500,extraprec=400)
    for z in roots:
        im=abs(z.imag) if hasattr(z,'imag') else 0
        line=mp.nstr(z,20)
        if im<mpf(10)**-40 and mp.re(z)>0:
            r=mp.re(z); x,res,det,dS=solve(rows,r); L6s=x[1]**2+x[2]**2+r*r-x[0]
            h=mpf('1e-15'); s2=(solve(rows,r+h)[3]-solve(rows,r-h)[3])/(2*h)
            line+='  X_C %s Y_C %s L6^2 %s L6 %s S %s max %s S'' %s'%tuple(mp.nstr(v,18) for v in (x[1],x[2],L6s,sqrt(L6s) if L6s>0 else mpf('nan'),sum(v*v for v in res),max(fabs(v) for v in res),s2))
        print(' ',line)
