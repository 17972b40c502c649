"""Two elastic blocks of plane-stress elements that meet along a face, by an independent program: docs/findings.md.

    python3 blocks.py            prints the table of studies/structures/structure-blocks.json; needs numpy and scipy

Half a block on its axis meets a frictionless wall with springs of twice the stiffness: the mirror image of the pair of blocks.
"""

import sys, os, time
os.environ.setdefault('OMP_NUM_THREADS','1'); os.environ.setdefault('OPENBLAS_NUM_THREADS','1')
import numpy as np, scipy.sparse as sp
from scipy.sparse.linalg import splu
sys.path.insert(0, os.path.join(os.path.dirname(__file__), '..', '..', 'examples', 'models'))
from plane_stress import block

def system(b,nu,n,ny=None,mass='lumped'):
    h=1/n
    ny=ny or max(4,round(b/2/h))
    M,K,p=block(n,ny,1.,b/2,nu=nu,mass=mass)   # half: rows j=0 is the axis
    N=len(p); keep=np.ones(2*N,bool)
    axis=np.arange(0,N,ny+1); keep[2*axis+1]=False
    idx=np.flatnonzero(keep); pos=-np.ones(2*N,int); pos[idx]=np.arange(len(idx))
    M=sp.csc_array(M)[idx][:,idx]; K=sp.csc_array(K)[idx][:,idx]
    face=pos[2*(n*(ny+1)+np.arange(ny+1))]
    w=np.full(ny+1,b/2/ny); w[[0,-1]]/=2
    X=(idx%2==0).astype(float)
    return M,K,face,w,X,ny

def lcp(A,d,free):
    """S<=0; free: closed. (A S)_F=d_F ; open: d-A S >=0"""
    left=4; least=len(d)+1
    for it in range(200):
        S=np.zeros(len(d))
        F=np.flatnonzero(free)
        if len(F): S[F]=np.linalg.solve(A[np.ix_(F,F)],d[F])
        q=d-A@S
        tol=1e-13*(np.abs(d).max()+1e-300)
        wrong=np.where(free,S>0,q<-tol)
        c=wrong.sum()
        if c==0: return S,free
        if c<least: least=c;left=4;free=free^wrong
        elif left>0: left-=1;free=free^wrong
        else:
            i=np.flatnonzero(wrong)[-1]; free=free.copy(); free[i]^=True
    raise ArithmeticError

def run(b,nu,n,gamma,dtf=.25,mass='lumped',T=3.2,ny=None,contact='spring'):
    """F(t)/F0 over t/L*C0; wall with 2k: the mirror image. gamma=k_I h/(E A) of the pair of blocks."""
    t0=time.time()
    M,K,face,w,X,ny=system(b,nu,n,ny,mass)
    dt=dtf/n; N=K.shape[0]; m=len(face)
    Kh=(4/dt**2*M+K).tocsc()
    lu=splu(Kh,permc_spec='MMD_AT_PLUS_A',options=dict(SymmetricMode=True),diag_pivot_thresh=0.)
    E=np.zeros((N,m)); E[face,np.arange(m)]=-1.
    G=lu.solve(E); H=-G[face]; H=(H+H.T)/2
    k=2*gamma*n*w
    A=H+np.diag(1/k)
    u=np.zeros(N); v=X.copy(); a=np.zeros(N)
    S=np.zeros(m); free=np.zeros(m,bool)
    steps=round(T/dt); F=np.zeros(steps+1); P=np.zeros((steps+1,m),np.float32); V=np.zeros(steps+1); R=np.zeros((steps+1,m),np.float32)
    mass_tot=X@(M@X); V[0]=1
    E0=.5*mass_tot
    for i in range(steps):
        us=lu.solve(M@(4/dt**2*u+4/dt*v+a))
        d=-us[face]
        S,free=lcp(A,d,free)
        un=us-G@S
        vn=2/dt*(un-u)-v; a=2/dt*(vn-v)-a; u,v=un,vn
        F[i+1]=-S.sum(); P[i+1]=-S/w; R[i+1]=-u[face]; V[i+1]=X@(M@v)/mass_tot
    return dict(b=b,nu=nu,n=n,ny=ny,gamma=gamma,dtf=dtf,mass=mass,t=dt*np.arange(steps+1),F=F/(b/2),P=P,R=R,V=V,w=w,sec=time.time()-t0,
        energy=(.5*v@(M@v)+.5*u@(K@u))/E0)
def facts(r):
    t,F,V=r['t'],r['F'],r['V']
    on=F>0
    last=np.flatnonzero(on)[-1]+1
    dt=t[1]
    mid=(t>=.4)&(t<=1.6)
    # first stretch of total force
    offs=np.flatnonzero(~on[1:])+1
    first=offs[0]*dt if len(offs) else np.nan
    return dict(b=r['b'],nu=r['nu'],n=r['n'],ny=r['ny'],g=r['gamma'],dtf=r['dtf'],peak=F.max(),tpeak=t[F.argmax()],mean=F[mid].mean(),std=F[mid].std(),min=F[mid].min(),
       e=-V[-1],first=first/2,last=last*dt/2,ctime=on.sum()*dt/2,maxp=r['P'].max(),pmid=r['P'][mid].mean(0),overlap=-r['R'].min(),energy=r['energy'],sec=r['sec'])
def show(f): return ' '.join(f"{k}={v:.4f}" if isinstance(v,float) else f"{k}={v}" for k,v in f.items() if k!='pmid')


if __name__ == '__main__':
    for b, nu in [(.2, 0.), (.2, .3), (.2, .45), (1., .3), (1., .45)]:
        for gamma in (.125, .25, .5, 1., 2.):
            f = facts(run(b, nu, 40, gamma, ny=10))
            print(f"width {b}, nu {nu}, gamma {gamma}: peak {f['peak']:.4f}, restitution {f['e']:.4f}, pressure {f['maxp']:.4f}")
