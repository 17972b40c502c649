"""How often the 95 % intervals of medians and fragilities contain what they estimate: the table of README.md, Coverage, by simulation.

Capacities are lognormal; ln of the true median is 0, the true dispersion 1 (of a cloud 0.4 at ln y = 0.5, slope 1). `bounded`: members with ln x
above 0.5 do not reach the limit (31 %). `trials`: eight values of x from -2 to 2 dispersions, independent, or all of the same members
(`scaled`). j: Student's t with n - 1 and the jackknife's standard error of the logarithm, as the product has it; p: percentile bootstrap (400
samples), e: expanded percentile (Hesterberg 2015), which are too narrow. m: median, d: dispersion. Own likelihoods, by Newton's method.
"""
import warnings

import numpy as np
from scipy.stats import norm,t as T,chi2,binom
from scipy.special import log_ndtr
warnings.simplefilter('ignore')
rng=np.random.default_rng(20261129)
REP=1000;B=400;q=norm.ppf(.975)
def newton(val,a,b,it=40):
    # val(a,b)->(ll,g0,g1,h00,h01,h11) arrays
    ll,*_=val(a,b)
    for _ in range(it):
        ll,g0,g1,h0,h1,h2=val(a,b)
        det=h0*h2-h1*h1; da=(h2*g0-h1*g1)/det; db=(h0*g1-h1*g0)/det
        s=np.ones(a.shape)
        for _ in range(20):
            bad=(b+s*db<=1e-3)|~(val(a+s*da,b+s*db)[0]>=ll-1e-10)
            if not bad.any(): break
            s=np.where(bad,s/2,s)
        a=a+s*da;b=b+s*db
    ll,g0,g1,h0,h1,h2=val(a,b)
    ok=np.isfinite(a)&np.isfinite(b)&(abs(g0)+abs(g1)<1e-5)&(b>2e-3)&(b<200)
    det=h0*h2-h1*h1
    aa,ab,bb=h2/det,-h1/det,h0/det
    vm=aa/b**2-2*a/b**3*ab+a*a/b**4*bb
    return a,b,-a/b,-np.log(b),np.sqrt(vm),np.sqrt(bb)/b,ok
mills=lambda u:np.exp(norm.logpdf(u)-log_ndtr(u))
def of_bounded(cnt,S1,S2,m,zc):
    def val(a,b):
        with np.errstate(all='ignore'):
            u=a+b*zc; l=mills(-u); w=l*(l-u)
            ll=cnt*np.log(b)-.5*(cnt*a*a+2*a*b*S1+b*b*S2)+m*log_ndtr(-u)
            return (ll,-(cnt*a+b*S1)-m*l,cnt/b-(a*S1+b*S2)-m*l*zc,cnt+m*w,S1+m*w*zc,cnt/b**2+S2+m*w*zc*zc)
    a0=-S1/np.maximum(cnt,1); v=np.maximum(S2/np.maximum(cnt,1)-a0**2,1e-3)
    b0=1/np.sqrt(v); return newton(val,a0*b0,b0)
def of_trials(K,n,z):
    K=K.astype(float)
    def val(a,b):
        with np.errstate(all='ignore'):
            u=a[...,None]+b[...,None]*z
            lp,ln=mills(u),mills(-u)
            ll=(K*log_ndtr(u)+(n-K)*log_ndtr(-u)).sum(-1)
            g=K*lp-(n-K)*ln; w=K*lp*(lp+u)+(n-K)*ln*(ln-u)
            return ll,g.sum(-1),(g*z).sum(-1),w.sum(-1),(w*z).sum(-1),(w*z*z).sum(-1)
    return newton(val,np.zeros(K.shape[:-1]),np.full(K.shape[:-1],2.))
def pct(x,ok,exp=None,n=None):
    x=np.where(ok,x,np.nan)
    p=.025 if exp is None else norm.cdf(-np.sqrt(n/(n-1))*T.ppf(.975,n-1))
    return np.nanpercentile(x,[100*p,100*(1-p)],axis=-1)
def cov(lo,hi,true,ok): return float(round(100*np.mean((lo<=true)&(true<=hi)&ok)/max(np.mean(ok),1e-9),1))
print("share of 95 % intervals that contain, in %",REP,B)
for n in(6,12,20,40):
    lows=[k for k in range(n) if binom.cdf(k,n,.5)<=.025]; k=max(lows) if lows else None
    print(n,'median order', None if k is None else 100*(1-2*binom.cdf(k,n,.5)))
    x=rng.standard_normal((REP*4,n)); m=x.mean(1); s=x.std(1,ddof=1)
    h=T.ppf(.975,n-1)*s/n**.5; ok=np.ones(REP*4,bool)
    print(n,'incremental exact', cov(m-h,m+h,0,ok), cov(s*np.sqrt((n-1)/chi2.ppf(.975,n-1)),s*np.sqrt((n-1)/chi2.ppf(.025,n-1)),1,ok))
    res={k:[] for k in('pm','pd','em','ed','jm','jd')}
    for i in range(REP):
        y=x[i]; b=y[rng.integers(0,n,(B,n))]; bm=b.mean(1); bs=b.std(1,ddof=1)
        for key,v,tr in(('m',bm,0),('d',bs,1)):
            for e in(None,1):
                lo,hi=pct(v,np.ones(B,bool),e,n); res[('p' if e is None else 'e')+key].append(lo<=tr<=hi)
        jm=(y.sum()-y)/(n-1); js=np.array([np.delete(y,j).std(ddof=1) for j in range(n)])
        ls=np.log(js); se=np.sqrt((n-1)/n*((ls-ls.mean())**2).sum()); hh=T.ppf(.975,n-1)*se
        res['jd'].append(abs(np.log(s[i]))<=hh); res['jm'].append(abs(m[i])<=h[i])
    print(n,'incremental bootstrap',{k:float(round(100*np.mean(v),1)) for k,v in res.items()},flush=True)
    # cloud
    REPc=4000; xx=rng.normal(0,.6,(REPc,n)); yy=xx+rng.normal(0,.4,(REPc,n)); L=.5
    mx=xx.mean(1);my=yy.mean(1);sxx=((xx-mx[:,None])**2).sum(1);sl=((xx-mx[:,None])*(yy-my[:,None])).sum(1)/sxx
    r=yy-my[:,None]-sl[:,None]*(xx-mx[:,None]);sd=np.sqrt((r*r).sum(1)/(n-2))
    w=T.ppf(.975,n-2)*sd; ok=(sl>0)&(abs(sl)*np.sqrt(sxx)>w)
    hgt=L-my; A=sl**2-w**2/sxx; C=hgt**2-w**2/n; rt=np.sqrt(np.maximum(sl**2*hgt**2-A*C,0))
    lo=mx+(sl*hgt-rt)/A;hi=mx+(sl*hgt+rt)/A
    d=np.log(sd/sl,where=ok,out=np.zeros(REPc)); se=q*np.sqrt(.5/(n-2)+(sd/sl)**2/sxx)
    se2=se/q*T.ppf(.975,n-2)
    print(n,'cloud', cov(lo,hi,L,ok),'dispersion',cov(d-se,d+se,np.log(.4),ok),'with t',cov(d-se2,d+se2,np.log(.4),ok),'ok',ok.mean(),flush=True)
    # bounded: bound at 0.5 sigma (31 % beyond)
    if n==6: continue
    zc=.5; x=rng.standard_normal((REP,n)); R=x<zc; y=np.where(R,x,0)
    a,b,lm,ld,sm,sd_,ok=of_bounded(R.sum(1),y.sum(1),(y*y).sum(1),n-R.sum(1),zc)
    tt=T.ppf(.975,n-1); ok&=R.sum(1)>1
    print(n,'bounded info',cov(lm-q*sm,lm+q*sm,0,ok),cov(ld-q*sd_,ld+q*sd_,0,ok),'with t',cov(lm-tt*sm,lm+tt*sm,0,ok),cov(ld-tt*sd_,ld+tt*sd_,0,ok),'ok',ok.mean(),flush=True)
    res={k:[] for k in('pm','pd','em','ed','jm','jd')}
    for i in range(REP):
        idx=np.vstack([rng.integers(0,n,(B,n)),[[j for j in range(n) if j!=k]+[-1] for k in range(n)]])
        valid=idx>=0; Rb=R[i][idx]&valid; yb=np.where(Rb,x[i][idx],0); cb=Rb.sum(1); N=valid.sum(1)
        _,_,bm,bd,_,_,o=of_bounded(cb,yb.sum(1),(yb*yb).sum(1),N-cb,zc); o&=cb>1
        for key,v in(('m',bm),('d',bd)):
            for e in(None,1):
                lo,hi=pct(v[:B],o[:B],e,n); res[('p' if e is None else 'e')+key].append(lo<=0<=hi)
            jv=v[B:]; se=np.sqrt((n-1)/n*((jv-jv.mean())**2).sum()); c=(lm if key=='m' else ld)[i]; res['j'+key].append(abs(c)<=tt*se)
    print(n,'bounded bootstrap',{k:float(round(100*np.mean(v),1)) for k,v in res.items()},flush=True)
    # trials
    z=np.linspace(-2,2,8)
    K=rng.binomial(n,norm.cdf(z),(REP,8))
    *_,lm,ld,sm,sd_,ok=of_trials(K,n,z)
    print(n,'likelihood info independent',cov(lm-q*sm,lm+q*sm,0,ok),cov(ld-q*sd_,ld+q*sd_,0,ok),'ok',ok.mean(),flush=True)
    x=rng.standard_normal((REP,n)); ex=(x[:,:,None]<z).astype(float); K=ex.sum(1)
    *_,lm,ld,sm,sd_,ok=of_trials(K,n,z)
    print(n,'likelihood info scaled',cov(lm-q*sm,lm+q*sm,0,ok),cov(ld-q*sd_,ld+q*sd_,0,ok),'ok',ok.mean(),flush=True)
    res={k:[] for k in('pm','pd','em','ed','jm','jd')}
    for i in range(600):
        if not ok[i]: continue
        W=np.vstack([rng.multinomial(n,np.ones(n)/n,B),1-np.eye(n)]); Kb=W@ex[i]; N=W.sum(1)[:,None]
        *_,bm,bd,_,_,o=of_trials(Kb,N,z)
        for key,v in(('m',bm),('d',bd)):
            for e in(None,1):
                lo,hi=pct(v[:B],o[:B],e,n); res[('p' if e is None else 'e')+key].append(lo<=0<=hi)
            jv=np.where(o[B:],v[B:],np.nan); se=np.sqrt((n-1)/n*np.nansum((jv-np.nanmean(jv))**2)); c=(lm if key=='m' else ld)[i]; res['j'+key].append(abs(c)<=T.ppf(.975,n-1)*se)
    print(n,'likelihood scaled bootstrap',{k:float(round(100*np.mean(v),1)) for k,v in res.items()},flush=True)
